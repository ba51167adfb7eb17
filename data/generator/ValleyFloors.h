// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "DrainageNetwork.h"
#include "Grid.h"

namespace islandgen
{

/// Cuts valley floors down to a gentle slope towards the river. Meandering rivers plane a floor whose width
/// grows with the square root of the drained area (170 m for 25 km²). The sides are too steep afterwards: at
/// least one step of erosion must follow.
/// Source: width as √A, Leopold & Maddock 1953.
void planeValleyFloors(Grid<float>& heightM, const DrainageNetwork& network, const Grid<std::uint8_t>& isSea,
                       float cellM);

} // namespace islandgen
