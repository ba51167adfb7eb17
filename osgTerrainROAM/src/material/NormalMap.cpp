// SPDX-License-Identifier: Apache-2.0
#include "NormalMap.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

/// The positions of one row of the map and of its two neighbouring rows.
using Row = std::vector<glm::dvec3>;

Row placedRow(const core::PlacedTile& tile, const MapGrid& grid, int row)
{
    Row positions(static_cast<std::size_t>(grid.width));
    for (int column = 0; column < grid.width; ++column)
        positions[static_cast<std::size_t>(column)] = grid.position(tile, column, row);
    return positions;
}

} // namespace

std::uint16_t packedComponent(double component)
{
    return static_cast<std::uint16_t>(std::lround((std::clamp(component, -1.0, 1.0) * 0.5 + 0.5) * 65535.0));
}

glm::dvec2 tiltAt(const osg::Image& normalMap, int x, int y)
{
    const auto* texel =
        reinterpret_cast<const std::uint16_t*>(normalMap.data()) + normalOffset(normalMap, x, y);
    return glm::dvec2(texel[0], texel[1]) * (2.0 / 65535.0) - 1.0;
}

void visitNormals(const core::PlacedTile& tile, const MapGrid& grid,
                  const std::function<void(int, int, const glm::dvec3&)>& visit)
{
    const auto rows = [&](int first, int end)
    {
        Row below = placedRow(tile, grid, first - 1);
        Row here = placedRow(tile, grid, first);
        for (int row = first; row < end; ++row)
        {
            Row above = placedRow(tile, grid, row + 1);
            for (int column = 0; column < grid.width; ++column)
            {
                const auto west = static_cast<std::size_t>(std::max(column - 1, 0));
                const auto east = static_cast<std::size_t>(std::min(column + 1, grid.width - 1));
                const auto at = static_cast<std::size_t>(column);
                visit(column, row,
                      glm::normalize(glm::cross(here[east] - here[west], above[at] - below[at])));
            }
            below = std::move(here);
            here = std::move(above);
        }
    };
    parallelRows(grid.height, rows);
}

osg::ref_ptr<osg::Image> normalMap(const core::PlacedTile& tile, const MapGrid& grid)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(grid.width, grid.height, 1, GL_RG, GL_UNSIGNED_SHORT);
    image->setInternalTextureFormat(GL_RG16);
    visitNormals(tile, grid,
                 [&](int column, int row, const glm::dvec3& normal)
                 { packNormal(normal, normalTexel(*image, column, row)); });
    return image;
}

} // namespace osgTerrainROAM
