// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/PathVertex.h"
#include "simulation/tour/LayDrive.h"

namespace simulation
{

/// When a drive is where. Units: metres, seconds.

/// Returns the speed that each point of a way allows: its limit, or less in a bend (2 m/s² sideways).
std::vector<double> limitsOn(const std::vector<WayPoint>& way);

/// Lowers speeds to what can be reached from, and braked to, their neighbours (1.5 m/s² along).
std::vector<double> reachable(const std::vector<WayPoint>& way, std::vector<double> speedMps);

/// Returns places at equal times, twice a second, until the way or the time is over.
std::vector<PathVertex> timedVertices(const std::vector<WayPoint>& way, const std::vector<double>& speedMps,
                                      double durationS);

} // namespace simulation
