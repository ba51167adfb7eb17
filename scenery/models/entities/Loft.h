// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A cross-section of a body with rounded sections: a superellipse about its middle. Units: metres.
struct LoftRing
{
    glm::dvec3 middle{0.0};
    glm::dvec3 halfA{0.0}, halfB{0.0}; ///< half axes; halfA × halfB points along the body. Both 0: a tip
    double power = 2.0;                ///< 2: an ellipse; more: towards a rectangle
};

/// Adds the surface over rings in order, one plain colour. It is closed when the first and the last ring are
/// tips.
/// `sides`: points of a ring, a multiple of 4. Precondition: a part with the texture plain has begun.
void addLoft(ModelBuilder& builder, const std::vector<LoftRing>& rings, int sides);

/// Adds a closed body along x of rounded rectangles, with flat ends.
struct HullSection
{
    double x, halfWidth, low, high;
};
void addHull(ModelBuilder& builder, const std::vector<HullSection>& sections, double power = 8.0);

/// Adds a closed round limb between two points, with rounded ends that reach `fromRadiusM` and `toRadiusM`
/// past them.
void addLimb(ModelBuilder& builder, const glm::dvec3& from, const glm::dvec3& to, double fromRadiusM,
             double toRadiusM);

} // namespace scenery::models
