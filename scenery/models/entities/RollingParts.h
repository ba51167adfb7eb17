// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/entities/EntityModel.h"

namespace scenery::models
{

/// The place of a wheel. Frame: the entity's. Units: metres.
struct WheelPlace
{
    glm::dvec3 hub{0.0};
    double radiusM = 0.32;
    bool steers = false;
    int travel = -1; ///< which of EntityMotion::wheelTravelM lifts it; below 0: none
};

/// Returns the matrix of a wheel that was made about its hub for the left side: it rolls, steers and springs.
/// On the right side it is turned about, so that its outside shows.
glm::dmat4 wheelMatrix(const WheelPlace& wheel, const EntityMotion& motion);

/// A rigid body and its wheels, in this order.
struct RollingPose
{
    glm::dmat4 body{1.0};
    std::vector<WheelPlace> wheels;

    std::vector<glm::dmat4> operator()(const EntityMotion& motion) const;
};

/// Adds two wheels for each axle of a shape, and sets `pose` to a RollingPose. The body must be the only part
/// so far.
/// `widthM`: of a tyre; `dualFrom`: axles from this one on have wheels twice as wide.
void addWheels(EntityModel& model, const EntityShape& shape, const glm::dmat4& body, double widthM,
               std::size_t dualFrom = 1000);

} // namespace scenery::models
