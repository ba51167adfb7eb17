// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgPMObjects/core/selection/HeldLevel.h>
#include <osgPMObjects/core/selection/Ranges.h>

namespace osgPMObjects::core
{

/// A boundary of ranges that overlap. Units: metres of the author's camera (SelectionView::distanceScale).
struct OverlapM
{
    double nearM = 0.0; ///< here the finer level comes back while approaching
    double farM = 0.0;  ///< up to here the finer level holds while receding
};

/// Distance ranges that overlap: between the two distances of a boundary the level stays what it was.
/// Invariant: isOverlappingRanges().
struct OverlappingRanges
{
    std::vector<OverlapM> boundaries; ///< near and far ascend, near > 0, near < far; one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level that is drawn

    /// Around the boundaries of plain ranges, from a boundary over √ratio to the boundary times √ratio. `ratio` > 1: far by
    /// near; above 1.05 / 0.95 = 1.105 nothing that goes back and forth by 5 % switches twice.
    static OverlappingRanges around(const Ranges& ranges, double ratio = kDefaultBand);
};

bool isOverlappingRanges(const OverlappingRanges& ranges);

/// The row of a distance, when the last one was `held`: the finer of two that are possible when none was.
/// Cost: as many comparisons as rows are passed, and two.
/// Source: paper 004, section 2.3.2 (King 2000; Rohlf & Helman 1994).
std::uint32_t overlappingRangeAt(const OverlappingRanges& ranges, double distanceM, HeldLevel held);

} // namespace osgPMObjects::core
