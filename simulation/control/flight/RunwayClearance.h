// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/flight/RunwayStrip.h"

namespace simulation
{

/// Returns how far the ground beyond the end of a runway rises above what a light aircraft clears by 5 m when
/// it climbs by 8 % from 400 m beyond the threshold; 0 or less: the way is free. Looks 1.5 km beyond the end:
/// from there on it may turn. Units: metres.
double aboveClimbOutM(const RunwayStrip& runway, const Ground& ground);

/// The same for a glide path of 3° to 150 m beyond the threshold, which clears the ground by 10 m, from a
/// distance before the threshold, 3 km at most.
double aboveFinalM(const RunwayStrip& runway, const Ground& ground, double fromM);

} // namespace simulation
