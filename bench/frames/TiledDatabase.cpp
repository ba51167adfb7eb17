// SPDX-License-Identifier: Apache-2.0
#include "TiledDatabase.h"

#include <algorithm>

#include <osgTerrain/Layer>
#include <osgTerrain/TerrainTile>

namespace framebench
{

using osgTerrainROAM::core::PlacedTile;

namespace
{

/// A square part of a tile: its south-western sample, and the cells along its side.
struct Square
{
    int column, row, cells;
};

osg::ref_ptr<osg::HeightField> heightsOf(const PlacedTile& tile, const Square& square)
{
    osg::ref_ptr<osg::HeightField> heights = new osg::HeightField;
    heights->allocate(static_cast<unsigned>(square.cells + 1), static_cast<unsigned>(square.cells + 1));
    for (int row = 0; row <= square.cells; ++row)
        for (int column = 0; column <= square.cells; ++column)
            heights->setHeight(static_cast<unsigned>(column), static_cast<unsigned>(row),
                               tile.samples().heightM(square.column + column, square.row + row));
    return heights;
}

osg::ref_ptr<osg::Image> coloursOf(const PlacedTile& tile, const Square& square)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(square.cells, square.cells, 1, GL_RGB, GL_UNSIGNED_BYTE, 1);
    for (int row = 0; row < square.cells; ++row)
        for (int column = 0; column < square.cells; ++column)
        {
            const float share = std::clamp(
                tile.samples().heightM(square.column + column, square.row + row) / 3000.0F, 0.0F, 1.0F);
            unsigned char* texel = image->data(static_cast<unsigned>(column), static_cast<unsigned>(row));
            texel[0] = static_cast<unsigned char>(90 + 150 * share);
            texel[1] = static_cast<unsigned char>(140 + 60 * share);
            texel[2] = static_cast<unsigned char>(70 + 160 * share);
        }
    return image;
}

osg::ref_ptr<osgTerrain::TerrainTile> terrainTile(const PlacedTile& tile, const Square& square)
{
    const double eastM = tile.field().spacingEastM, northM = tile.field().spacingNorthM;
    osg::ref_ptr<osgTerrain::Locator> locator = new osgTerrain::Locator;
    locator->setCoordinateSystemType(osgTerrain::Locator::PROJECTED);
    locator->setTransformAsExtents(square.column * eastM, square.row * northM,
                                   (square.column + square.cells) * eastM,
                                   (square.row + square.cells) * northM);
    osg::ref_ptr<osgTerrain::HeightFieldLayer> heights =
        new osgTerrain::HeightFieldLayer(heightsOf(tile, square));
    osg::ref_ptr<osgTerrain::ImageLayer> colours = new osgTerrain::ImageLayer(coloursOf(tile, square));
    heights->setLocator(locator);
    colours->setLocator(locator);
    osg::ref_ptr<osgTerrain::TerrainTile> part = new osgTerrain::TerrainTile;
    part->setTileID({0, square.column / square.cells, square.row / square.cells});
    part->setLocator(locator);
    part->setElevationLayer(heights);
    part->setColorLayer(0, colours);
    return part;
}

} // namespace

osg::ref_ptr<osgTerrain::Terrain> tiledDatabase(const PlacedTile& tile, int cells,
                                                osgTerrain::TerrainTechnique* technique)
{
    osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    terrain->setTerrainTechniquePrototype(technique);
    for (int row = 0; row + cells < tile.grid().side(); row += cells)
        for (int column = 0; column + cells < tile.grid().side(); column += cells)
            terrain->addChild(terrainTile(tile, {column, row, cells}));
    return terrain;
}

} // namespace framebench
