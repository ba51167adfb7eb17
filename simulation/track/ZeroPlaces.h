// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Takes the fixes at 0° north, 0° east out of a track, where the others are farther from there than 1°:
/// recorders write them before they know where they are. Returns the numbers of those that were taken out,
/// ascending; `lines` gets their lines of the file.
std::vector<std::size_t> dropZeroPlaces(FlightTrack& track, std::vector<int>& lines);

} // namespace simulation
