// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// What brute force finds in one drawn mesh; all counts are 0 in a sound one.
struct DrawnMeshReport
{
    std::size_t tJunctions = 0; ///< edges inside the data that no neighbouring triangle shares
    std::size_t cracks =
        0; ///< data samples under no triangle, and vertices that, without morphing, are off their samples
    double maxErrorPx =
        0.0; ///< largest distance in the picture between a visible sample and the drawn surface
};

/// Checks a mesh from outside: it sees only what is drawn, not the tree that made it.
/// Every data sample is compared with the triangle that covers it, both projected with the view's real matrix;
/// samples nearer than the near distance or outside the picture have no error (spec 1 D, goal L2).
/// `view` absent: topology alone. Frame: the tile's local frame.
/// Cost: one visit per data sample, about 0.1 µs each where it can be visible.
DrawnMeshReport checkDrawnMesh(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view);

} // namespace osgTerrainROAM::core
