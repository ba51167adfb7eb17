// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/player/EntityState.h"

namespace scenery
{

/// Where a body or an eye stands and how it is turned.
/// Frame: position in the world (local east-north-up); body axes x forward, y left, z up, as OpenSCENARIO has them.
/// Units: metres. Invariant: worldFromBody is a rotation; its columns are forward, left and up.
struct Pose
{
    glm::dvec3 positionWorld{0.0};
    glm::dmat3 worldFromBody{1.0};

    const glm::dvec3& forward() const { return worldFromBody[0]; }
    const glm::dvec3& left() const { return worldFromBody[1]; }
    const glm::dvec3& up() const { return worldFromBody[2]; }
    glm::dvec3 worldFromBodyPoint(const glm::dvec3& point) const
    {
        return positionWorld + worldFromBody * point;
    }
};

Pose poseOf(const simulation::EntityState& entity);

/// An eye that looks at a place with the horizon level. Straight up or down it has west on its left.
Pose poseLookingAt(const glm::dvec3& eyeWorld, const glm::dvec3& targetWorld);

/// An eye fixed in a body, looking along the body's x axis. `eyeInBody` in the body's frame.
Pose eyeInBody(const Pose& body, const glm::dvec3& eyeInBody);

/// The view matrix of OpenGL (looking along −z, y up) of an eye that looks along its body's x axis.
glm::dmat4 viewFromWorld(const Pose& eye);

/// The matrix that places a model made in the body's frame.
glm::dmat4 worldFromModel(const Pose& body);

} // namespace scenery
