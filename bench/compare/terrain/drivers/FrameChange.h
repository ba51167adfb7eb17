// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include <viewlod/ViewState.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

namespace terraintool
{

/// What differs between the meshes of two frames.
struct FrameChange
{
    std::size_t newTriangles = 0; ///< that the frame before did not draw
    double popPx = 0.0; ///< largest change of the drawn height at a sample of the raster, in centre pixels
};

/// Compares the meshes of two frames as one eye sees them. Only triangles that differ are looked at.
/// Precondition: vertices move in height only. Cost: O(n log n) of the triangles, and the samples of those
/// that differ.
FrameChange changeBetween(const osgTerrainROAM::core::PlacedTile& tile,
                          const osgTerrainROAM::core::DrawnMesh& before,
                          const osgTerrainROAM::core::DrawnMesh& now, const viewlod::ViewState& view);

} // namespace terraintool
