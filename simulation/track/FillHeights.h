// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Gives the fixes without a height that of the way between the fixes beside them that have one: by the
/// times, or by the number of the fix where there are none; before the first and behind the last, that of the
/// nearest. Between heights that count from different surfaces, and in a track without any height, nothing is
/// given. Returns how many were given. Precondition: fixes are in the order of their times.
std::size_t fillHeights(FlightTrack& track);

} // namespace simulation
