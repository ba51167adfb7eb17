// SPDX-License-Identifier: Apache-2.0
#include "view/RoadsideCamera.h"

#include <algorithm>

namespace trainer
{

scenery::Pose RoadsideCamera::update(const scenery::Pose& body, const simulation::GroundProvider& ground)
{
    const glm::dvec3 up(0.0, 0.0, 1.0);
    if (!_eye || glm::distance(*_eye, body.positionWorld) > _settings.mostM)
    {
        glm::dvec3 forward = body.forward() - up * body.forward().z;
        if (glm::length(forward) < 1e-6) forward = {1.0, 0.0, 0.0};
        forward = glm::normalize(forward);
        glm::dvec3 eye =
            body.positionWorld + _settings.aheadM * forward + _settings.asideM * glm::cross(forward, up);
        const auto under = ground ? ground(eye.x, eye.y, eye.z) : std::nullopt;
        // Beside a body high in the air the camera stands at its height.
        const bool isNear = under && body.positionWorld.z - under->heightM < _settings.mostM;
        eye.z = (isNear ? under->heightM : body.positionWorld.z) + _settings.heightM;
        _eye = eye;
    }
    return scenery::poseLookingAt(*_eye, body.positionWorld + up * _settings.lookAtM);
}

} // namespace trainer
