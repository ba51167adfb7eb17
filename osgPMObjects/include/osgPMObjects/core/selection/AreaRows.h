// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

/// Which level is drawn at which projected area: row i while the area is at least `leastPx[i]`, the last row below all of
/// them.
/// Invariant: isAreaRows(). Units: pixels squared.
struct AreaRows
{
    std::vector<double> leastPx;      ///< positive, descending, one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level that is drawn

    /// Rows with half as many faces each, from the full mesh down to `leastFaces` or the last level, each drawn from where
    /// one of its faces would cover less than `pixelsPerTriangle` of the area, when half of them are seen.
    static AreaRows halving(const LevelTable& table, double pixelsPerTriangle = 1.5,
                            std::uint32_t leastFaces = 8);
};

bool isAreaRows(const AreaRows& rows);

/// The row of an area: it comes back to the finer one at the row's own area, and leaves it at that divided by `band`² (an
/// area goes with the square of the distance). `band` ≥ 1, as for kDefaultBand; 1: no hysteresis. The finer row when none
/// is held.
/// Source: paper 004, section 2.3.3; hysteresis is ours.
std::uint32_t areaRowAt(const AreaRows& rows, double areaPx, double band, HeldLevel held);

} // namespace osgPMObjects::core
