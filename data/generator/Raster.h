// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "Grid.h"

namespace islandgen
{

/// Mean over a square of 2·`radius`+1 cells, applied twice (a tent along each axis); edges repeated. O(n).
Grid<float> blurred(const Grid<float>& grid, int radius);

/// Distance in cells from each cell to the nearest marked one; 4·side where nothing is marked. Exact, O(n).
/// Source: Meijster, Roerdink, Hesselink 2000.
Grid<float> distanceTo(const Grid<std::uint8_t>& marked);

} // namespace islandgen
