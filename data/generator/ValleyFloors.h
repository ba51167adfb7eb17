// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "DrainageNetwork.h"
#include "Grid.h"

namespace islandgen
{

/// Rivers swing from side to side and plane a floor whose width grows with the root of the drained area
/// (170 m where 25 km² drain). Cuts the floors down to a gentle slope towards the river; the sides stand too
/// steep afterwards, so at least one step of erosion must follow.
/// Source: width as √A, Leopold & Maddock 1953.
void planeValleyFloors(Grid<float>& heightM, const DrainageNetwork& network, const Grid<std::uint8_t>& isSea,
                       float cellM);

} // namespace islandgen
