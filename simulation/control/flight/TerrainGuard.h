// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/control/flight/FlightSense.h"

namespace simulation
{

/// What keeps an aircraft off the ground ahead.
struct TerrainAdvice
{
    double leastM = -1e9; ///< scene's z to hold or to climb to
    std::optional<double>
        track{}; ///< to fly in place of the own one, radians from north; absent: the own is free
    bool isUrgent() const { return track.has_value() || isClimbing; }
    bool isClimbing = false; ///< the ground ahead rises: full power now
};

/// Looks along the track ahead of an aircraft, and to both sides where a climb would not clear what lies
/// there. It looks twice a second, and keeps its advice in between; ground that does not rise ahead never
/// changes what is flown.
/// Determinism: by the states that it is shown. Cost: 20 look-ups twice a second, 260 at most.
class TerrainGuard
{
public:
    const TerrainAdvice& look(const FlightSense& sense, const Ground& ground, double timeS);

    /// Of the last look.
    const TerrainAdvice& advice() const { return _advice; }

private:
    TerrainAdvice _advice;
    double _lookedS = -1e9;
};

} // namespace simulation
