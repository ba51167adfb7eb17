// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "Grid.h"
#include "Noise.h"

namespace islandgen
{

/// The drainage network: the way of the water of every cell.
/// Invariant: following `receiver` from any cell reaches a base cell (its own receiver); a receiver stands
/// before its donors in `downstreamFirst`. drainsEverywhere() checks.
struct DrainageNetwork
{
    Grid<std::int32_t> receiver;               ///< the neighbour that takes the cell's water
    Grid<float> areaCells;                     ///< cells that drain through a cell, itself included
    std::vector<std::int32_t> downstreamFirst; ///< every cell, base cells and low cells first
};

/// Raises every depression of `heightM` to its outlet, a little more with each step away from it, so that
/// each cell that is not a base cell has a lower neighbour. Returns the cells in the order in which they were
/// flooded, the lowest first.
/// Cost: O(n log n) with small constants, see HeightQueue.
/// Source: Barnes, Lehman, Mulla 2014, "Priority-flood", algorithm 3 (with gradient); ours: HeightQueue.
std::vector<std::int32_t> fillDepressions(Grid<float>& heightM, const Grid<std::uint8_t>& isBase,
                                          float riseM = 1e-3f);

/// Fills depressions in `heightM` and routes every cell to one lower neighbour: the steepest, after each
/// slope has been multiplied by a random factor 1 ± `wander`. Over many steps the random factor hides the
/// eight directions of the grid.
/// Source: steepest descent as in Braun & Willett 2013, section 2; chance as in Fairfield & Leymarie 1991.
DrainageNetwork routeDrainage(Grid<float>& heightM, const Grid<std::uint8_t>& isBase, Noise chance,
                              float wander);

/// Tells whether the water of every cell reaches a base cell.
bool drainsEverywhere(const DrainageNetwork& network, const Grid<std::uint8_t>& isBase);

} // namespace islandgen
