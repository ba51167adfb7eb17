// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <viewlod/Sight.h>

#include <osgTerrainROAM/core/roam/GridTriangle.h>
#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/Refinement.h>
#include <osgTerrainROAM/core/roam/SplitBounds.h>

namespace osgTerrainROAM::core
{

/// Writes the leaves of the mesh for an eye, refined where it is in `sight`, into `leaves`, top-down and
/// without memory of earlier frames. It is the reference that every incremental driver must equal, and must
/// be faster than.
/// Cost: O(leaves). Source: Lindstrom & Pascucci, *Visualization of large terrains made easy*, 2001 (SOAR).
/// Differs: exact errors.
void refineFromScratch(const SplitBounds& bounds, const viewlod::ViewState& view, double tolerancePx,
                       std::vector<GridTriangle>& leaves, const viewlod::Sight& sight = {});

/// Makes the mesh that leaves of the bintree draw: every one that is drawn, or its patch, with vertices of
/// its own.
DrawnMesh meshOfLeaves(const SplitBounds& bounds, std::span<const GridTriangle> leaves);

} // namespace osgTerrainROAM::core
