// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdint>

#include "NormalMap.h"

namespace osgTerrainROAM
{

namespace
{

glm::dvec3 normalAt(const core::PlacedTile& tile, const MapGrid& grid, int x, int y)
{
    const auto position = [&](int column, int row) { return grid.position(tile, column, row); };
    return glm::normalize(
        glm::cross(position(x + 1, y) - position(x - 1, y), position(x, y + 1) - position(x, y - 1)));
}

} // namespace

void updateNormals(osg::Image& map, const core::PlacedTile& tile, const MapGrid& grid,
                   std::span<const core::GridRect> moved)
{
    bool isTouched = false;
    for (const core::GridRect& rect : moved)
    {
        const core::GridRect texels =
            core::GridRect{(rect.west - grid.west) / grid.step - 1, (rect.south - grid.south) / grid.step - 1,
                           (rect.east - grid.west) / grid.step + 1, (rect.north - grid.south) / grid.step + 1}
                .cutTo({0, 0, grid.width - 1, grid.height - 1});
        isTouched = isTouched || !texels.isEmpty();
        for (int y = texels.south; y <= texels.north; ++y)
            for (int x = texels.west; x <= texels.east; ++x)
                packNormal(normalAt(tile, grid, x, y), normalTexel(map, x, y));
    }
    if (isTouched) map.dirty();
}

} // namespace osgTerrainROAM
