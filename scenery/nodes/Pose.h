// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/state/EntityState.h"

namespace scenery
{

/// The position and attitude of a body or a camera.
/// Frame: position in the world (local east-north-up); body axes x forward, y left, z up, as in OpenSCENARIO.
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

/// Returns the pose of a camera that looks at a point with a level horizon. Straight up or down it has west
/// on its left.
Pose poseLookingAt(const glm::dvec3& eyeWorld, const glm::dvec3& targetWorld);

/// Returns the pose of a camera fixed in a body and looking along its x axis. `eyeInBody`: in the frame of
/// the body.
Pose eyeInBody(const Pose& body, const glm::dvec3& eyeInBody);

/// Returns the view matrix of OpenGL (looking along −z, y up) of a camera that looks along its body x axis.
glm::dmat4 viewFromWorld(const Pose& eye);

/// Returns the matrix that places a model made in the frame of the body.
glm::dmat4 worldFromModel(const Pose& body);

} // namespace scenery
