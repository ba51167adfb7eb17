// SPDX-License-Identifier: Apache-2.0
#include "NormalMap.h"

#include <cmath>
#include <cstdint>

#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

std::uint16_t packed(double component)
{
    return static_cast<std::uint16_t>(std::lround((std::clamp(component, -1.0, 1.0) * 0.5 + 0.5) * 65535.0));
}

} // namespace

glm::dvec3 sampleNormal(const core::PlacedTile& tile, int column, int row, int step)
{
    const int lastColumn = tile.dataColumns() - 1;
    const int lastRow = tile.dataRows() - 1;
    const glm::dvec3 east =
        tile.position(std::min(column + step, lastColumn), row) - tile.position(std::max(column - step, 0), row);
    const glm::dvec3 north =
        tile.position(column, std::min(row + step, lastRow)) - tile.position(column, std::max(row - step, 0));
    return glm::normalize(glm::cross(east, north));
}

osg::ref_ptr<osg::Image> normalMap(const core::PlacedTile& tile, const MapGrid& grid)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(grid.width, grid.height, 1, GL_RG, GL_UNSIGNED_SHORT);
    image->setInternalTextureFormat(GL_RG16);
    parallelRows(grid.height,
                 [&](int first, int end)
                 {
                     for (int row = first; row < end; ++row)
                     {
                         auto* out = reinterpret_cast<std::uint16_t*>(image->data(0, row));
                         for (int column = 0; column < grid.width; ++column)
                         {
                             const glm::dvec3 n =
                                 sampleNormal(tile, column * grid.step, row * grid.step, grid.step);
                             *out++ = packed(n.x);
                             *out++ = packed(n.y);
                         }
                     }
                 });
    return image;
}

} // namespace osgTerrainROAM
