// SPDX-License-Identifier: Apache-2.0
// Borders between tiles that are refined for themselves: nothing of the background shows through.
#include <cmath>

#include <gtest/gtest.h>

#include "SyntheticField.h"
#include "TechniquePictures.h"

namespace
{

using namespace techniquepictures;
using namespace techniquescene;

/// Background seen in 40 pictures from a little above the cross of four tiles: downwards, along the seams and
/// across.
std::size_t holes(osgTerrain::Terrain& terrain, const std::function<void(osgTerrain::Terrain&)>& change = {})
{
    Pictures pictures(&terrain);
    pictures.from(viewpoints().front());
    if (change) change(terrain);
    testsupport::Random random(11);
    std::size_t found = 0;
    for (int i = 0; i < 40; ++i)
    {
        const double along = 900.0 + 2000.0 * random.unit(), angle = 6.28318 * random.unit();
        const osg::Vec3d on = i % 2 == 0 ? osg::Vec3d(1920.0, along, 0.0) : osg::Vec3d(along, 1920.0, 0.0);
        const double up = hillAt(on.x(), on.y());
        const osg::Vec3d eye = on + osg::Vec3d(250.0 * std::cos(angle), 250.0 * std::sin(angle), up + 330.0);
        found += magentaPixels(*pictures.from({eye, osg::Vec3d(on.x(), on.y(), up)}));
    }
    return found;
}

void withoutSkirts(osgTerrain::Terrain& terrain)
{
    forEachTile(terrain,
                [](osgTerrain::TerrainTile& tile)
                {
                    ASSERT_TRUE(dynamic_cast<osgTerrainROAM::RoamTechnique&>(*tile.getTerrainTechnique())
                                    .drawable()
                                    ->setSkirtM(std::nullopt));
                });
}

/// Two tiles of every other sample beside two of all.
osg::ref_ptr<osgTerrain::Terrain> twoLevels(double tolerancePx)
{
    const auto terrain = ours(tolerancePx);
    const auto coarse = [&](double x0, double y0, unsigned int child)
    { terrain->setChild(child, tileOf({.columns = 33, .rows = 33, .x0 = x0, .y0 = y0})); };
    coarse(0.0, 0.0, 0);
    coarse(1920.0, 1920.0, 3);
    return terrain;
}

} // namespace

TEST(TechniqueSeam, ShowsNoBackgroundBetweenTiles)
{
    for (const double tolerancePx : {0.5, 1.0, 3.0, 10.0})
        EXPECT_EQ(holes(*ours(tolerancePx)), 0u) << tolerancePx;
}

TEST(TechniqueSeam, ShowsNoBackgroundWhereTrianglesCrossTheDatasEdge)
{
    for (const double tolerancePx : {1.0, 3.0, 10.0})
        EXPECT_EQ(holes(*ours(tolerancePx, {.columns = 50, .rows = 41})), 0u) << tolerancePx;
}

TEST(TechniqueSeam, ShowsNoBackgroundWhileMorphing)
{
    const auto terrain = ours(3.0);
    static_cast<osgTerrainROAM::RoamTechnique*>(terrain->getTerrainTechniquePrototype())->setMorphing(true);
    EXPECT_EQ(holes(*terrain), 0u);
}

TEST(TechniqueSeam, ShowsNoBackgroundBetweenLevels)
{
    for (const double tolerancePx : {0.5, 1.0, 10.0})
        EXPECT_EQ(holes(*twoLevels(tolerancePx)), 0u) << tolerancePx;
}

TEST(TechniqueSeam, WithoutSkirtsItWouldShow)
{
    // The mutation for the tests above.
    EXPECT_GT(holes(*ours(3.0), withoutSkirts), 30u);
    EXPECT_GT(holes(*ours(3.0, {.columns = 50, .rows = 41}), withoutSkirts), 30u);
    EXPECT_GT(holes(*twoLevels(1.0), withoutSkirts), 30u);
}
