// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "DrainageNetwork.h"
#include "Grid.h"
#include "IslandPlan.h"
#include "Noise.h"

namespace islandgen
{

/// Raises the sea to height 0, over land that rivers have cut down to a lower sea, and shapes the shore:
/// rivers fill their drowned mouths and build deltas, waves cut headlands back and close small inlets, low
/// shores become beaches. Returns the mask of sea cells; their heights are 0, all other heights are above 0.
Grid<std::uint8_t> raiseSea(Grid<float>& heightM, const IslandPlan& plan, Noise noise);

/// Turns sea in front of river mouths into land, as far as the rivers' sediment suffices: the nearest water
/// first, by a randomly varied distance. Heights of the new land stay as they were, below 0.
/// Units: `sedimentM`: metres of height that each cell loses to its river.
void buildDeltas(Grid<std::uint8_t>& isSea, const Grid<float>& heightM, const DrainageNetwork& network,
                 const Grid<float>& sedimentM, Noise noise);

} // namespace islandgen
