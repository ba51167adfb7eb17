// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

#include "simulation/state/EntityState.h"

namespace simulation
{

/// Leads an entity from where a person gave it back to where the scenario has it: the difference of both
/// poses fades by a smooth step. The longer the way sideways and the slower the entity, the longer it takes,
/// two seconds at least: at most about a fifth of the speed goes sideways.
class GivenBack
{
public:
    /// `left`: as the person has left it. `own`: where the scenario goes on, at the same time.
    GivenBack(const EntityState& left, const EntityState& own, double timeS);

    bool isOver(double timeS) const { return timeS >= _beganS + _lastsS; }

    /// Moves a state of the scenario's towards where the person has left it.
    void lead(EntityState& state, double timeS) const;

    double asideM() const { return glm::length(_apart); }
    double lastsS() const { return _lastsS; }

private:
    glm::dvec3 _apart{0.0};
    double _headingDeg = 0.0, _pitchDeg = 0.0, _rollDeg = 0.0;
    double _beganS = 0.0, _lastsS = 0.0;
};

} // namespace simulation
