// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// The findings of a brute-force check of one drawn mesh; all counts are 0 in a sound mesh.
struct DrawnMeshReport
{
    /// edges inside the data that no neighbouring triangle shares; where parts overlap: that do not lie
    std::size_t tJunctions = 0;
    ///< below another part
    /// data samples under no triangle, and vertices that, without morphing, are off their samples; triangles
    /// without
    std::size_t cracks = 0;
    ///< extent, or turned over in plan
    double maxErrorPx =
        0.0; ///< largest distance in the frame, in pixels, between a visible sample and the drawn surface
};

/// Checks a drawn mesh without the tree that made it.
/// It compares every data sample with the triangle that covers it, both projected with the view's real
/// matrix. Samples nearer than the near distance or outside the frame have no error. Where parts overlap
/// (DrawnMesh::overlaps()) the uppermost one counts, and without a T-junction no ray from above it passes
/// between them. `view` absent: checks the topology only. Frame: the tile's local frame.
/// Cost: one visit per data sample, about 0.1 µs for each that can be visible.
DrawnMeshReport checkDrawnMesh(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState* view);

/// The largest distance of such a check alone, without what it says of the topology.
double drawnErrorPx(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState& view);

} // namespace osgTerrainROAM::core
