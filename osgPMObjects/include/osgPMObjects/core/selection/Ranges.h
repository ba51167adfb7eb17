// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// The distance ranges of a model, one level each: row i is drawn from `boundariesM[i - 1]` up to
/// `boundariesM[i]`.
/// Invariant: isRanges(). Units: metres of the author's camera (SelectionView::distanceScale).
struct Ranges
{
    std::vector<double> boundariesM;  ///< positive, ascending, one fewer than rows
    std::vector<std::uint32_t> steps; ///< by row: the level to draw
};

bool isRanges(const Ranges& ranges);

/// Chooses the row for a distance, without hysteresis: a distance that varies about a boundary changes the
/// row each time; OverlappingRanges avoids that. Cost: linear in the rows, which are few.
/// Source: Sadykov & Zakharov, *Choosing the level of detail in continuous simplification of polygonal
/// objects* (2002), section 2.3.1.
std::uint32_t rangeAt(std::span<const double> boundariesM, double distanceM);

} // namespace osgPMObjects::core
