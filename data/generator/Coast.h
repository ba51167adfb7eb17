// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "DrainageNetwork.h"
#include "Grid.h"
#include "IslandPlan.h"
#include "Noise.h"

namespace islandgen
{

/// Lets the sea rise to height 0 over land that was cut by rivers to a lower sea, and shapes the shore: rivers
/// fill their drowned mouths and build deltas, waves cut headlands back and close small inlets, low shores
/// become beaches.
/// Result: the cells that are sea; their heights are 0, those of all others above 0.
Grid<std::uint8_t> raiseSea(Grid<float>& heightM, const IslandPlan& plan, Noise noise);

/// Turns sea into low land in front of the river mouths, as far as the rivers' sediment goes: the nearest
/// water first, over a distance that chance varies. The height of the new land is left as it was, below 0.
/// Units: `sedimentM` in metres of one cell, per cell: what each cell loses to its river.
void buildDeltas(Grid<std::uint8_t>& isSea, const Grid<float>& heightM, const DrainageNetwork& network,
                 const Grid<float>& sedimentM, Noise noise);

} // namespace islandgen
