// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/Pose.h"

namespace scenery
{

Pose poseOf(const simulation::EntityState& entity)
{
    return {entity.position, entity.bodyToLocal()};
}

Pose eyeInBody(const Pose& body, const glm::dvec3& eyeInBody)
{
    return {body.worldFromBodyPoint(eyeInBody), body.worldFromBody};
}

glm::dmat4 worldFromModel(const Pose& body)
{
    glm::dmat4 matrix(body.worldFromBody);
    matrix[3] = glm::dvec4(body.positionWorld, 1.0);
    return matrix;
}

Pose poseLookingAt(const glm::dvec3& eyeWorld, const glm::dvec3& targetWorld)
{
    constexpr double kTiny = 1e-9;
    const glm::dvec3 away = targetWorld - eyeWorld;
    const double distance = glm::length(away);
    const glm::dvec3 forward = distance > kTiny ? away / distance : glm::dvec3(0.0, 1.0, 0.0);
    glm::dvec3 left = glm::cross(glm::dvec3(0.0, 0.0, 1.0), forward);
    if (glm::length(left) < kTiny) left = glm::dvec3(-1.0, 0.0, 0.0);
    left = glm::normalize(left);
    return {eyeWorld, glm::dmat3(forward, left, glm::cross(forward, left))};
}

glm::dmat4 viewFromWorld(const Pose& eye)
{
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(-eye.left(), eye.up(), -eye.forward()));
    glm::dmat4 view(rotation);
    view[3] = glm::dvec4(-(rotation * eye.positionWorld), 1.0);
    return view;
}

} // namespace scenery
