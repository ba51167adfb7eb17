// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include <osg/Image>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// Calls visit(x, y, normal) for each texel of the grid, from several threads, with the unit normal in the tile's frame of
/// the full-resolution surface, from central differences of placed positions.
void visitNormals(const core::PlacedTile& tile, const MapGrid& grid,
                  const std::function<void(int, int, const glm::dvec3&)>& visit);

/// -1…1 on 0…65535.
std::uint16_t packedComponent(double component);

/// Puts x and y of a normal into two texels of 16 bits, one beside the other.
inline void packNormal(const glm::dvec3& normal, std::uint16_t* out)
{
    out[0] = packedComponent(normal.x);
    out[1] = packedComponent(normal.y);
}

/// Those normals: x and y of the unit
/// normal in the tile's frame as 16 bits each (-1…1 on 0…65535), so that shading neither depends on the level of
/// detail nor shows bands. z follows, for it is positive.
osg::ref_ptr<osg::Image> normalMap(const core::PlacedTile& tile, const MapGrid& grid);

/// Draws the texels of a normal map again whose samples or neighbours lie in what has moved. NormalUpdate.cpp.
void updateNormals(osg::Image& map, const core::PlacedTile& tile, const MapGrid& grid,
                   std::span<const core::GridRect> moved);

/// x and y of the unit normal at a texel of a normalMap().
glm::dvec2 tiltAt(const osg::Image& normalMap, int x, int y);

} // namespace osgTerrainROAM
