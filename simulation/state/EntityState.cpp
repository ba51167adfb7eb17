// SPDX-License-Identifier: Apache-2.0
#include "simulation/state/EntityState.h"

#include <cmath>

namespace simulation
{

glm::dmat3 EntityState::bodyToLocal() const
{
    const double ch = std::cos(glm::radians(headingDeg));
    const double sh = std::sin(glm::radians(headingDeg));
    const double cp = std::cos(glm::radians(pitchDeg));
    const double sp = std::sin(glm::radians(pitchDeg));
    const double cr = std::cos(glm::radians(rollDeg));
    const double sr = std::sin(glm::radians(rollDeg));
    // Rz(heading) · Ry(pitch) · Rx(roll), multiplied out.
    return {glm::dvec3(ch * cp, sh * cp, -sp),
            glm::dvec3(ch * sp * sr - sh * cr, sh * sp * sr + ch * cr, cp * sr),
            glm::dvec3(ch * sp * cr + sh * sr, sh * sp * cr - ch * sr, cp * cr)};
}

double EntityState::compassDeg() const
{
    const double compass = std::fmod(90.0 - headingDeg, 360.0);
    return compass < 0.0 ? compass + 360.0 : compass;
}

} // namespace simulation
