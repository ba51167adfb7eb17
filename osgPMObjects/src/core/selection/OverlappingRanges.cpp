// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <cmath>

#include <osgPMObjects/core/selection/OverlappingRanges.h>

namespace osgPMObjects::core
{

OverlappingRanges OverlappingRanges::around(const Ranges& ranges, double ratio)
{
    assert(ratio > 1.0);
    OverlappingRanges overlapping{{}, ranges.steps};
    const double half = std::sqrt(ratio);
    for (const double boundary : ranges.boundariesM)
        overlapping.boundaries.push_back({boundary / half, boundary * half});
    return overlapping;
}

bool isOverlappingRanges(const OverlappingRanges& ranges)
{
    const auto& b = ranges.boundaries;
    const auto turnsBack = [](const OverlapM& a, const OverlapM& next)
    { return next.nearM <= a.nearM || next.farM <= a.farM; };
    return ranges.steps.size() == b.size() + 1 && (b.empty() || b.front().nearM > 0.0) &&
           std::all_of(b.begin(), b.end(),
                       [](const OverlapM& o) { return o.nearM < o.farM && std::isfinite(o.farM); }) &&
           std::adjacent_find(b.begin(), b.end(), turnsBack) == b.end() &&
           std::is_sorted(ranges.steps.begin(), ranges.steps.end());
}

std::uint32_t overlappingRangeAt(const OverlappingRanges& ranges, double distanceM, HeldLevel held)
{
    const auto& b = ranges.boundaries;
    return heldRow(
        held, static_cast<std::uint32_t>(b.size()),
        [&](std::uint32_t row) { return distanceM >= b[row - 1].farM; },
        [&](std::uint32_t row) { return distanceM < b[row - 1].nearM; });
}

} // namespace osgPMObjects::core
