// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "simulation/player/actions/RunningAction.h"
#include "simulation/road/StopAtSign.h"

namespace simulation
{

/// A line on the way of an entity before which it has to stop.
struct StopAhead
{
    double gapM = 0.0;   ///< from its front, along the lanes that it will take
    bool isSign = false; ///< where it stops, looks and goes on; else a light that does not let pass
};

/// What stopAhead() looks for.
struct StopSearch
{
    double lookAheadM = 0.0;
    double brakesMps2 = 0.0; ///< a line for which it would have to brake harder is passed
    /// where it has already stopped, by the odometer of its front; or null
    const StopAtSign* signs = nullptr;
};

/// Returns the next line at which an entity has to stop; nothing: the way is free.
/// Cost: a microsecond for every 5 m.
std::optional<StopAhead> stopAhead(ActionScene& scene, int actor, const StopSearch& search);

} // namespace simulation
