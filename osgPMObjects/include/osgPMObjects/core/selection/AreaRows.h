// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/LevelTable.h>

namespace osgPMObjects::core
{

/// A table that chooses a level by the projected area of an object: row i is drawn while the area is at least
/// `leastPx[i]`, the last row below all of them.
/// Invariant: isAreaRows(). Units: pixels squared.
struct AreaRows
{
    std::vector<double> leastPx;      ///< pixels squared; positive, descending, one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level to draw

    /// Returns rows each with half as many faces as the row before, from the full mesh down to `leastFaces`
    /// or the last level. A row ends where one of its faces covers less than `pixelsPerTriangle`, if half of
    /// its faces are visible.
    static AreaRows halving(const LevelTable& table, double pixelsPerTriangle = 1.5,
                            std::uint32_t leastFaces = 8);
};

bool isAreaRows(const AreaRows& rows);

/// Chooses the row for an area, with hysteresis: it changes to the finer row at that row's own area, and back
/// at that area divided by `band`² (an area falls with the square of the distance). `band` ≥ 1, see
/// kDefaultBand; 1 means no hysteresis. Without a held row it returns the finer one. `areaPx`: pixels
/// squared.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.3. Differs: hysteresis.
std::uint32_t areaRowAt(const AreaRows& rows, double areaPx, double band, HeldLevel held);

} // namespace osgPMObjects::core
