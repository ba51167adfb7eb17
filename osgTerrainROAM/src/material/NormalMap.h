// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

#include <osg/Image>

#include "MapGrid.h"

namespace osgTerrainROAM
{

/// Calls visit(x, y, normal) for each texel of the grid, from several threads. The unit normal is that of the
/// full-resolution surface, by central differences of positions, in the tile's frame.
void visitNormals(const core::PlacedTile& tile, const MapGrid& grid,
                  const std::function<void(int, int, const glm::dvec3&)>& visit);

/// Maps -1…1 to 0…65535.
std::uint16_t packedComponent(double component);

/// Writes x and y of a normal into two adjacent values of 16 bits.
inline void packNormal(const glm::dvec3& normal, std::uint16_t* out)
{
    out[0] = packedComponent(normal.x);
    out[1] = packedComponent(normal.y);
}

/// Makes the normal map: x and y of the unit normal in the tile's frame, 16 bits each (-1…1 on 0…65535); z is
/// positive and follows. With it shading does not depend on the level of detail, and 16 bits show no bands.
osg::ref_ptr<osg::Image> normalMap(const core::PlacedTile& tile, const MapGrid& grid);

/// Computes the texels of a normal map again whose samples or neighbours have moved. NormalUpdate.cpp.
void updateNormals(osg::Image& map, const core::PlacedTile& tile, const MapGrid& grid,
                   std::span<const core::GridRect> moved);

/// Returns where the two values of a texel of a normalMap() begin, counted in values: its rows follow each
/// other without a gap. osg::Image::data(x, y) works out the size of a texel from its format at each call.
inline std::size_t normalOffset(const osg::Image& normalMap, int x, int y)
{
    const auto width = static_cast<std::size_t>(normalMap.s());
    return 2 * (static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x));
}

/// Returns a texel of a normalMap(), to write to.
inline std::uint16_t* normalTexel(osg::Image& normalMap, int x, int y)
{
    return reinterpret_cast<std::uint16_t*>(normalMap.data()) + normalOffset(normalMap, x, y);
}

/// Returns x and y of the unit normal at a texel of a normalMap().
glm::dvec2 tiltAt(const osg::Image& normalMap, int x, int y);

} // namespace osgTerrainROAM
