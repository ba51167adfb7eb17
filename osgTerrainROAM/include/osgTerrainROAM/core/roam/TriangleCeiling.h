// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <viewlod/Budget.h>
#include <viewlod/Sight.h>
#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

/// Finds the smallest τ ≥ budget.errorTolerancePx at which the mesh for `view`, refined where it is in
/// `sight`, has at most budget.maxTriangles leaves. The result depends on bounds, eye and sight alone;
/// `guessPx`, the τ of the last frame or any other number, changes only the time.
/// Cost: O(maxTriangles), whatever the size of the terrain. Algorithm: TriangleCeiling.cpp.
double toleranceWithinCeiling(const SplitBounds& bounds, const viewlod::ViewState& view,
                              const viewlod::Budget& budget, double guessPx,
                              const viewlod::Sight& sight = {});

} // namespace osgTerrainROAM::core
