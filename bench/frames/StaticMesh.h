// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <osg/Geode>
#include <osg/Geometry>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace framebench
{

/// The number of triangles that geometries have drawn since the last reset.
struct DrawCount
{
    std::uint64_t triangles = 0;
};

/// Makes every geometry below `node` add to `count` when it is drawn, which has to outlive it.
void countDraws(osg::Node& node, DrawCount& count);

/// Makes a mesh in static buffers for the vertex shader of the terrain: attributes 0 (position, in whole
/// steps) and 1 (grid). It is always drawn: culling is off.
osg::ref_ptr<osg::Geode> staticMesh(const osgTerrainROAM::core::DrawnMesh& mesh);

/// Cells along the side of a patch of fullGrid(), where it is drawn in patches.
inline constexpr int kFullGridPatchCells = 64;

/// Makes the grid of full resolution in static buffers. Each cell is cut along the diagonal of the finest
/// level of the bintree, so that it is the limit of every refinement. It is one piece that is always drawn,
/// or square patches of `patchCells` cells that OSG culls; they share the vertex buffers.
osg::ref_ptr<osg::Geode> fullGrid(const osgTerrainROAM::core::PlacedTile& tile, int patchCells);

} // namespace framebench
