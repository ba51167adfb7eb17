// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "Grid.h"
#include "IslandPlan.h"
#include "Noise.h"

namespace islandgen
{

/// Heights in metres; 0 in the sea and above 0 on land.
struct Land
{
    Grid<float> heightM;
    Grid<std::uint8_t> isSea;
};

/// Lets an island rise from the sea and rivers cut it, first on a coarse grid for a long time, then on ever
/// finer ones, each for a shorter time: large valleys are old, small ones young, and the whole costs about
/// as much as ten steps on the finest grid.
/// `side`: 2^n+1, at least 129.
Land evolveLand(const IslandPlan& plan, int side, Noise noise);

} // namespace islandgen
