// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <viewlod/Budget.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

/// The smallest τ ≥ budget.errorTolerancePx at which the mesh for `view` has at most budget.maxTriangles leaves (the
/// target itself when it has). A function of bounds and eye alone: `guessPx`, the τ of the frame before or any other number,
/// changes only the time it takes.
/// Cost: O(maxTriangles), whatever the terrain's size. Source: spec 1 D, "Triangle ceiling".
double toleranceWithinCeiling(const SplitBounds& bounds, const viewlod::ViewState& view,
                              const viewlod::Budget& budget, double guessPx);

} // namespace osgTerrainROAM::core
