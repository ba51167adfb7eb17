// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/Ranges.h>

namespace osgPMObjects::core
{

/// A boundary of overlapping ranges. Units: metres of the author's camera (SelectionView::distanceScale).
struct OverlapM
{
    double nearM = 0.0; ///< an approaching object changes to the finer level here
    double farM = 0.0;  ///< a receding object changes to the coarser level here
};

/// Distance ranges that overlap: between the two distances of a boundary the level stays what it was.
/// Invariant: isOverlappingRanges().
struct OverlappingRanges
{
    std::vector<OverlapM> boundaries; ///< near and far ascend, 0 < near < far; one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level to draw

    /// Widens the boundaries of plain ranges: each goes from the boundary / √ratio to the boundary · √ratio.
    /// `ratio` > 1; a distance that varies by ±5 % switches at most once if `ratio` is above 1.05 / 0.95 =
    /// 1.105.
    static OverlappingRanges around(const Ranges& ranges, double ratio = kDefaultBand);
};

bool isOverlappingRanges(const OverlappingRanges& ranges);

/// Chooses the row for a distance. The held row decides inside an overlap; the finer row if none is held.
/// Cost: as many comparisons as rows are passed, and two.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.2, after King (2000) and Rohlf & Helman (1994).
std::uint32_t overlappingRangeAt(const OverlappingRanges& ranges, double distanceM, HeldLevel held);

} // namespace osgPMObjects::core
