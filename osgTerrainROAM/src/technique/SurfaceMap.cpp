// SPDX-License-Identifier: Apache-2.0
#include "SurfaceMap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "../material/MapGrid.h"
#include "../material/NormalMap.h"

namespace osgTerrainROAM
{

namespace
{

/// A locator may count columns or rows the other way round: then the cross product of the two points down.
double sideUp(const core::PlacedTile& tile)
{
    const int column = tile.grid().dataColumns() / 2, row = tile.grid().dataRows() / 2;
    const glm::dvec3 at = tile.frame().positionAt(column, row, 0.0);
    const glm::dvec3 normal = glm::cross(tile.frame().positionAt(column + 0.5, row, 0.0) - at,
                                         tile.frame().positionAt(column, row + 0.5, 0.0) - at);
    return glm::dot(normal, tile.frame().positionAt(column, row, 1.0) - at) < 0.0 ? -1.0 : 1.0;
}

std::uint16_t share(float height, const osg::Vec2f& range)
{
    return range.y() > 0.0f
               ? static_cast<std::uint16_t>(std::lround((height - range.x()) / range.y() * 65535.0f))
               : std::uint16_t(0);
}

std::uint8_t holeCode(const ElevationSamples& samples, int column, int row)
{
    int voids = 0, which = 0;
    for (int corner = 0; corner < 4; ++corner)
        if (samples.voidAt(column + corner % 2, row + corner / 2))
        {
            ++voids;
            which = corner + 1;
        }
    return static_cast<std::uint8_t>(voids == 0 ? 5 : voids == 1 ? which : 0);
}

} // namespace

SurfaceMap surfaceMap(const TileGround& ground)
{
    const core::PlacedTile& tile = ground.tile->tile;
    const std::vector<float>& heights = ground.samples->heights;
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const MapGrid grid(tile);
    SurfaceMap map;
    map.heights = osg::Vec2f(*low, *high - *low);
    map.fromGrid = osg::Vec4f(1.0f / static_cast<float>(grid.step * grid.width),
                              1.0f / static_cast<float>(grid.step * grid.height),
                              0.5f / static_cast<float>(grid.width), 0.5f / static_cast<float>(grid.height));
    map.image = new osg::Image;
    map.image->allocateImage(grid.width, grid.height, 1, GL_RGBA, GL_UNSIGNED_SHORT);
    map.image->setInternalTextureFormat(GL_RGBA16);
    const double up = sideUp(tile);
    visitNormals(tile, grid,
                 [&](int x, int y, const glm::dvec3& normal)
                 {
                     auto* out = reinterpret_cast<std::uint16_t*>(map.image->data(x, y));
                     for (int i = 0; i < 3; ++i)
                         out[i] = packedComponent(up * normal[i]);
                     const std::size_t row = static_cast<std::size_t>(y) * grid.step;
                     out[3] = share(heights[row * ground.samples->columns + x * grid.step], map.heights);
                 });
    return map;
}

osg::ref_ptr<osg::Image> holeMap(const ElevationSamples& samples)
{
    if (samples.isVoid.empty()) return nullptr;
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(samples.columns - 1, samples.rows - 1, 1, GL_RED, GL_UNSIGNED_BYTE, 1);
    image->setInternalTextureFormat(GL_R8);
    for (int row = 0; row < samples.rows - 1; ++row)
        for (int column = 0; column < samples.columns - 1; ++column)
            *image->data(column, row) = holeCode(samples, column, row);
    return image;
}

} // namespace osgTerrainROAM
