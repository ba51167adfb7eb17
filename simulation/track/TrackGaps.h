// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/Trajectory.h"
#include "simulation/track/FlightTrack.h"

namespace simulation
{

/// Puts vertices between those of a timed track where a smooth curve through them would swing out: in gaps of
/// time that are more than three times as long as a neighbour, close to the short neighbour at first, then
/// each twice as far. Over more than 30 s they lie on the straight way; else on a cubic that stays between
/// the two vertices in each coordinate, so half a metre of noise stays one. Vertices are GeoPositions with
/// times that rise; those given stay.
/// Source: Fritsch & Butland, *A method for constructing local monotone piecewise cubic interpolants*, SIAM
/// J. Sci. Stat. Comput. 5, 1984.
void fillGaps(std::vector<Vertex>& vertices);

/// Returns a line for the user about gaps of more than 30 s that are five times as long as usual; nothing:
/// there are none.
std::optional<std::string> gapsOf(const FlightTrack& track);

} // namespace simulation
