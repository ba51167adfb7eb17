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

/// Simulates uplift and river erosion of an island: first on a coarse grid for a long time, then on ever
/// finer grids, each for a shorter time. So large valleys are old and small ones young, and the cost is about
/// that of ten steps on the finest grid.
/// `side`: 2^n+1, at least 129.
Land evolveLand(const IslandPlan& plan, int side, Noise noise);

} // namespace islandgen
