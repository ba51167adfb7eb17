// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/GivenBack.h"

#include <algorithm>

#include <foundation/Angle.h>

namespace simulation
{

namespace
{

constexpr double kLeastS = 2.0;
constexpr double kSidewaysShare = 0.2; ///< of the speed
constexpr double kLeastMps = 5.0;      ///< that counts as the speed

} // namespace

GivenBack::GivenBack(const EntityState& left, const EntityState& own, double timeS)
    : _apart(left.position - own.position),
      _headingDeg(foundation::wrappedDeg(left.headingDeg - own.headingDeg)),
      _pitchDeg(foundation::wrappedDeg(left.pitchDeg - own.pitchDeg)),
      _rollDeg(foundation::wrappedDeg(left.rollDeg - own.rollDeg)),
      _beganS(timeS)
{
    const double aside = kSidewaysShare * std::max(std::abs(left.speedMps), kLeastMps);
    _lastsS = std::max(kLeastS, 1.5 * glm::length(_apart) / aside); // a smooth step's middle is 1.5 as fast
}

void GivenBack::lead(EntityState& state, double timeS) const
{
    const double share = std::clamp((timeS - _beganS) / _lastsS, 0.0, 1.0);
    const double left = 1.0 - glm::smoothstep(0.0, 1.0, share);
    state.position += left * _apart;
    state.velocity -= 6.0 * share * (1.0 - share) / _lastsS * _apart;
    state.headingDeg = foundation::wrappedDeg(state.headingDeg + left * _headingDeg);
    state.pitchDeg = foundation::wrappedDeg(state.pitchDeg + left * _pitchDeg);
    state.rollDeg = foundation::wrappedDeg(state.rollDeg + left * _rollDeg);
}

} // namespace simulation
