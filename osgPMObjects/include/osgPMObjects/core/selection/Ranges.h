// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// The distance ranges of a model, one level each: row i is drawn from `boundariesM[i - 1]` on up to `boundariesM[i]`.
/// Invariant: isRanges(). Units: metres of the author's camera (SelectionView::distanceScale).
struct Ranges
{
    std::vector<double> boundariesM;  ///< positive, ascending, one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level that is drawn
};

bool isRanges(const Ranges& ranges);

/// The row of a distance. At a boundary that the eye trembles about it changes with each tremor: OverlappingRanges does not.
/// Cost: linear in the rows, which are few.
/// Source: paper 004, section 2.3.1.
std::uint32_t rangeAt(std::span<const double> boundariesM, double distanceM);

} // namespace osgPMObjects::core
