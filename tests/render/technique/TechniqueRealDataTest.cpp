// SPDX-License-Identifier: Apache-2.0
// Real ground as a database of stock osgTerrain tiles: ours against GeometryTechnique, along a way over its
// seams.
#include <gtest/gtest.h>

#include <osgTerrain/GeometryTechnique>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "RealData.h"
#include "TechniquePictures.h"

namespace
{

using namespace techniquepictures;
using osgTerrainROAM::core::HeightField;

constexpr int kCells = 128, kSide = 4;
constexpr double kCellM = 30.0;

osg::ref_ptr<osgTerrain::TerrainTile> tileOfPart(const HeightField& field, int firstColumn, int firstRow)
{
    osg::ref_ptr<osg::HeightField> heights = new osg::HeightField;
    heights->allocate(kCells + 1, kCells + 1);
    for (int row = 0; row <= kCells; ++row)
        for (int column = 0; column <= kCells; ++column)
            heights->setHeight(static_cast<unsigned>(column), static_cast<unsigned>(row),
                               field.heightM(firstColumn + column, firstRow + row));
    osg::ref_ptr<osgTerrain::Locator> locator = new osgTerrain::Locator;
    locator->setCoordinateSystemType(osgTerrain::Locator::PROJECTED);
    locator->setTransformAsExtents(firstColumn * kCellM, firstRow * kCellM, (firstColumn + kCells) * kCellM,
                                   (firstRow + kCells) * kCellM);
    osg::ref_ptr<osgTerrain::HeightFieldLayer> layer = new osgTerrain::HeightFieldLayer(heights);
    layer->setLocator(locator);
    osg::ref_ptr<osgTerrain::TerrainTile> tile = new osgTerrain::TerrainTile;
    tile->setLocator(locator);
    tile->setElevationLayer(layer);
    return tile;
}

osg::ref_ptr<osgTerrain::Terrain> databaseOf(const HeightField& field,
                                             osgTerrain::TerrainTechnique* technique)
{
    osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    terrain->setTerrainTechniquePrototype(technique);
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column)
            terrain->addChild(tileOfPart(field, column * kCells, row * kCells));
    return terrain;
}

/// Pixels far brighter than each of their eight neighbours: what a coarse mip level on a slope seen edge-on
/// makes.
int brightDots(const osg::Image& picture)
{
    const auto level = [&](int x, int y)
    { return static_cast<int>(*picture.data(static_cast<unsigned>(x), static_cast<unsigned>(y))); };
    int dots = 0;
    for (int y = 1; y + 1 < picture.t(); ++y)
        for (int x = 1; x + 1 < picture.s(); ++x)
        {
            int brightest = 0;
            for (int i = 0; i < 9; ++i)
                if (i != 4) brightest = std::max(brightest, level(x + i % 3 - 1, y + i / 3 - 1));
            dots += level(x, y) > brightest + 24;
        }
    return dots;
}

} // namespace

TEST(TechniqueRealData, LooksAsGeometryTechniqueDoesAndShowsNoBackgroundAtSeams)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(dem, "dem/N46E008.tif");
    const auto field = osgTerrainROAM::core::importDem(dem);
    ASSERT_TRUE(field) << field.error().message();
    const auto mine = databaseOf(*field, new osgTerrainROAM::RoamTechnique);
    const auto theirs = databaseOf(*field, new osgTerrain::GeometryTechnique);
    Pictures ofMine(mine), ofTheirs(theirs);
    int dots = 0, theirDots = 0;
    for (int step = 0; step < 12; ++step)
    {
        const double along = 1500.0 + 900.0 * step;
        const osg::Vec3d place(along, 0.4 * along + 3000.0, 0.0);
        const double ground =
            field->heightM(static_cast<int>(place.x() / kCellM), static_cast<int>(place.y() / kCellM));
        const Viewpoint ahead{place + osg::Vec3d(0, 0, ground + 600.0),
                              place + osg::Vec3d(3000, 1500, ground)};
        const Unlikeness found = unlikeness(*ofMine.from(ahead), *ofTheirs.from(ahead));
        dots += brightDots(*ofMine.from(ahead));
        theirDots += brightDots(*ofTheirs.from(ahead));
        EXPECT_LT(found.mean, 6.0) << step;
        EXPECT_LT(found.shareFar, 0.12) << step;
        const Viewpoint down{place + osg::Vec3d(0, 0, ground + 900.0), place + osg::Vec3d(200, 100, ground)};
        EXPECT_EQ(magentaPixels(*ofMine.from(down)), 0u) << step;
    }
    EXPECT_LE(dots, theirDots + 12) << "theirs: " << theirDots;
    std::cout << "bright dots: " << dots << ", GeometryTechnique " << theirDots << '\n';
}
