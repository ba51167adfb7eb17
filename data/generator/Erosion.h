// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "DrainageNetwork.h"
#include "Grid.h"

namespace islandgen
{

/// The rates that shape the land in one time step, cell by cell.
struct ErosionRates
{
    Grid<float> upliftM; ///< metres in the whole step
    Grid<float>
        riverErosion; ///< K·dt: times the root of the drained square metres, metres of a cell per cell
    Grid<float> creepCells2;   ///< D·dt in cells²
    Grid<float> criticalSlope; ///< the steepest stable slope, metres per metre
    float cellM = 0.0f;
    float deposition = 0.0f; ///< G: share of the sediment in a river that settles, over its mean erosion
};

/// Computes one step of dh/dt = U − K·√A·S + G·Q/A, with Q the sediment from upstream. It is implicit in h
/// and therefore stable for any step. Slopes above the critical one slide down to it. Rivers that leave the
/// mountains build fans and plains.
/// Cost: a few passes over the network, O(n).
/// Source: Braun & Willett 2013, equations 21–23 with m = 0.5, n = 1; Yuan et al. 2019, equation 9, for the
/// sediment, solved by a fixed number of repetitions. Ours: sliding in the same pass.
void erodeRivers(Grid<float>& heightM, const DrainageNetwork& network, const ErosionRates& rates);

/// Computes one step of dh/dt = div(D grad h), implicit along the rows and then along the columns; cells with
/// `isBase` stay. Creates no new maximum or minimum along a line. Cost: O(n).
/// Source: locally one-dimensional scheme, Samarskii 1962.
void creep(Grid<float>& heightM, const Grid<float>& creepCells2, const Grid<std::uint8_t>& isBase);

} // namespace islandgen
