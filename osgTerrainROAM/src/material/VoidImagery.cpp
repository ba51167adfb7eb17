// SPDX-License-Identifier: Apache-2.0
#include "VoidImagery.h"

#include "MapGrid.h"

namespace osgTerrainROAM
{

namespace
{

constexpr unsigned char kLight[4] = {235, 95, 30, 200}, kDark[4] = {190, 60, 20, 200};
constexpr int kStripe = 4; ///< texels

bool isFilled(const core::PlacedTile& tile, const MapGrid& grid, int x, int y)
{
    const int cell = tile.grid().cellSide();
    return !tile.field().measured.holds(x * grid.step / cell, y * grid.step / cell);
}

} // namespace

ImageryLayer voidImagery(const core::PlacedTile& tile)
{
    ImageryLayer layer;
    if (tile.field().measured.hasAll()) return layer;
    const MapGrid grid(tile);
    layer.image = new osg::Image;
    layer.image->allocateImage(grid.width, grid.height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    layer.image->setInternalTextureFormat(GL_RGBA8);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
        {
            const unsigned char* const colour = (x + y) / kStripe % 2 == 0 ? kLight : kDark;
            unsigned char* const out = layer.image->data(x, y);
            for (int i = 0; i < 4; ++i)
                out[i] = i < 3 || isFilled(tile, grid, x, y) ? colour[i] : 0;
        }
    layer.lastGrid = glm::dvec2((grid.width - 1) * grid.step, (grid.height - 1) * grid.step);
    layer.texelM = 1e-6; // finer than any other
    return layer;
}

} // namespace osgTerrainROAM
