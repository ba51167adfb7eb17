// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osg/Geode>
#include <osg/Geometry>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace framebench
{

/// Triangles that geometries have drawn since it was last set to zero.
struct DrawCount
{
    std::uint64_t triangles = 0;
};

/// Makes every geometry below `node` add to `count` when it is drawn, which has to outlive it.
void countDraws(osg::Node& node, DrawCount& count);

/// A mesh in static buffers, for the terrain's vertex shader: attributes 0 (high), 1 (low) and 2 (grid).
/// It is drawn wherever it lies: culling is off.
osg::ref_ptr<osg::Geode> staticMesh(const osgTerrainROAM::core::DrawnMesh& mesh);

/// Cells along the side of a patch of fullGrid(), where it is drawn in patches.
inline constexpr int kFullGridPatchCells = 64;

/// The full-resolution grid in static buffers, every cell cut along the diagonal that the bintree's finest level has,
/// so that it is the mesh that any refinement tends to. In one piece that is always drawn, or in square patches of
/// `patchCells` that OSG culls against the frustum; they share the vertex buffers.
osg::ref_ptr<osg::Geode> fullGrid(const osgTerrainROAM::core::PlacedTile& tile, int patchCells);

} // namespace framebench
