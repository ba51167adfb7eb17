// SPDX-License-Identifier: Apache-2.0
#include "technique/TileGround.h"

#include <cmath>

#include <gtest/gtest.h>

#include "TechniqueScene.h"
#include "technique/SurfaceMap.h"

namespace
{

using namespace osgTerrainROAM;
using namespace techniquescene;
using osgTerrain::Locator;

/// Where our tile has a sample, in the model's frame.
osg::Vec3d placed(const TileGround& ground, int column, int row)
{
    const glm::dvec3 p = ground.tile->tile.position(column, row);
    return osg::Vec3d(p.x, p.y, p.z) * ground.modelFromLocal;
}

/// Farthest that any sample lies from where the locator says it is.
double worstError(const osgTerrain::TerrainTile& tile, const TileGround& ground, double verticalScale = 1.0)
{
    const osgTerrain::Layer& layer = *tile.getElevationLayer();
    double worst = 0.0;
    for (unsigned row = 0; row < layer.getNumRows(); ++row)
        for (unsigned column = 0; column < layer.getNumColumns(); ++column)
        {
            float height = 0.0f;
            layer.getValue(column, row, height);
            osg::Vec3d model;
            const osg::Vec3d place(column / (layer.getNumColumns() - 1.0), row / (layer.getNumRows() - 1.0),
                                   height * verticalScale);
            masterLocator(tile)->convertLocalToModel(place, model);
            worst = std::max(
                worst, (model - placed(ground, static_cast<int>(column), static_cast<int>(row))).length());
        }
    return worst;
}

osg::ref_ptr<osgTerrain::TerrainTile> tileWithTransform(const osg::Matrixd& transform)
{
    const auto tile = tileOf({.columns = 40, .rows = 23});
    tile->getLocator()->setTransform(transform);
    return tile;
}

} // namespace

TEST(TileGround, HasEverySampleWhereAProjectedLocatorPutsIt)
{
    const auto tile = tileOf({.columns = 50, .rows = 33, .x0 = 456000.0, .y0 = 5100000.0});
    const auto ground = tileGround(*tile);
    ASSERT_TRUE(ground);
    EXPECT_LT(worstError(*tile, *ground), 1e-4) << "of 5100 km";
    EXPECT_EQ(ground->tile->tile.grid().dataColumns(), 50);
}

TEST(TileGround, FollowsALocatorThatTurnsAndMirrors)
{
    const osg::Matrixd turned = osg::Matrixd::scale(2000, 900, 1) * osg::Matrixd::rotate(0.6, 0, 0, 1) *
                                osg::Matrixd::translate(5e5, -4e6, 12.0);
    const osg::Matrixd mirrored =
        osg::Matrixd::scale(2000, -900, 1) * osg::Matrixd::translate(100.0, 900.0, 0.0);
    for (const osg::Matrixd& transform : {turned, mirrored})
    {
        const auto tile = tileWithTransform(transform);
        EXPECT_LT(worstError(*tile, *tileGround(*tile)), 1e-4);
    }
}

TEST(TileGround, KeepsCellsOfDegreesApart)
{
    // A plane of degrees, with heights in degrees as well: 30 m are 0.00027.
    const auto tile = tileWithTransform(osg::Matrixd::scale(0.02, 0.01, 1.0 / 111000.0) *
                                        osg::Matrixd::translate(8, 46, 0));
    const auto ground = tileGround(*tile);
    EXPECT_LT(worstError(*tile, *ground), 1e-9);
    EXPECT_LT(ground->tile->tile.frame().vertexStepM(), 0.01 * ground->tile->tile.field().spacingEastM);
}

TEST(TileGround, LiesOnTheEarthOfAGeocentricLocator)
{
    const auto tile = tileOf({.columns = 65, .rows = 49, .type = Locator::GEOCENTRIC});
    const auto ground = tileGround(*tile);
    EXPECT_EQ(ground->tile->tile.frame().placement(), core::Placement::curved);
    EXPECT_LT(worstError(*tile, *ground), 2e-3);
    EXPECT_NEAR(ground->tile->tile.field().spacingNorthM, 41.17, 0.05);
}

TEST(TileGround, LiesOnALocatorsOwnEllipsoid)
{
    const auto tile = tileOf({.type = Locator::GEOCENTRIC});
    tile->getLocator()->setEllipsoidModel(new osg::EllipsoidModel(6371000.0, 6371000.0));
    // The normals stay WGS84's, up to 0.19° off: 500 m high that is 1.7 m.
    EXPECT_LT(worstError(*tile, *tileGround(*tile)), 2.0);
}

TEST(TileGround, CoversAHemisphere)
{
    const auto tile = tileOf({.columns = 65, .rows = 65, .type = Locator::GEOCENTRIC});
    tile->getLocator()->setTransformAsExtents(0.0, -osg::PI_2, osg::PI, osg::PI_2);
    EXPECT_LT(worstError(*tile, *tileGround(*tile)), 0.1);
}

TEST(TileGround, TheWrongLocatorWouldShow)
{
    // The mutation for the tests above.
    const auto tile = tileOf({});
    const auto ground = tileGround(*tile);
    tile->getLocator()->setTransformAsExtents(0.0, 0.0, 1921.0, 1920.0);
    EXPECT_GT(worstError(*tile, *ground), 0.9);
}

TEST(TileGround, ScalesHeightsByTheTerrainsVerticalScale)
{
    const auto terrain = terrainOf(1, {});
    terrain->setVerticalScale(2.5f);
    auto& tile = static_cast<osgTerrain::TerrainTile&>(*terrain->getChild(0));
    tile.setTerrain(terrain);
    const auto ground = tileGround(tile);
    EXPECT_LT(worstError(tile, *ground, 2.5), 1e-3);
    EXPECT_GT(worstError(tile, *ground, 1.0), 100.0);
    EXPECT_EQ(ground->heightScale, 2.5);
    tile.setTerrain(nullptr);
}

TEST(TileGround, FillsVoidsAndRemembersThem)
{
    const auto tile = tileOf({});
    auto& layer = static_cast<osgTerrain::HeightFieldLayer&>(*tile->getElevationLayer());
    layer.setValidDataOperator(new osgTerrain::NoDataValue(-9999.0f));
    for (unsigned row = 20; row < 30; ++row)
        for (unsigned column = 10; column < 16; ++column)
            layer.getHeightField()->setHeight(column, row, -9999.0f);
    const auto ground = tileGround(*tile);
    EXPECT_GT(ground->tile->tile.samples().heightM(12, 25), 0.0f);
    EXPECT_TRUE(ground->samples->voidAt(12, 25));
    EXPECT_FALSE(ground->samples->voidAt(9, 25));
    const auto holes = holeMap(*ground->samples);
    ASSERT_TRUE(holes);
    EXPECT_EQ(*holes->data(12, 25), 0);
    EXPECT_EQ(*holes->data(9, 25), 0) << "two corners are void";
    EXPECT_EQ(*holes->data(9, 19), 4) << "the north-eastern one is";
    EXPECT_EQ(*holes->data(8, 19), 5);
    EXPECT_FALSE(holeMap(*tileGround(*tileOf({}))->samples)) << "nothing is void";
}

TEST(TileGround, GivesTheRimOfAVoidTheLayersDefaultWhereTheTileWantsThat)
{
    const auto tile = tileOf({});
    auto& layer = static_cast<osgTerrain::HeightFieldLayer&>(*tile->getElevationLayer());
    layer.setValidDataOperator(new osgTerrain::ValidRange(0.0f, 5000.0f));
    layer.setDefaultValue(osg::Vec4(77.0f, 0, 0, 0));
    for (unsigned column = 10; column < 20; ++column)
        for (unsigned row = 10; row < 20; ++row)
            layer.getHeightField()->setHeight(column, row, -1.0f);
    tile->setTreatBoundariesToValidDataAsDefaultValue(true);
    const auto samples = elevationSamples(*tile);
    EXPECT_EQ(samples->heights[10 * 65 + 12], 77.0f);
    EXPECT_FALSE(samples->voidAt(12, 10));
    EXPECT_TRUE(samples->voidAt(12, 12));
}

TEST(TileGround, IsFlatWithoutAnElevationLayer)
{
    const auto tile = tileOf({});
    tile->setElevationLayer(static_cast<osgTerrain::Layer*>(nullptr));
    const auto ground = tileGround(*tile);
    ASSERT_TRUE(ground);
    EXPECT_EQ(placed(*ground, 64, 64), osg::Vec3d(1920.0, 1920.0, 0.0));
}

TEST(TileGround, TakesAnImageOfHeights)
{
    const auto tile = tileOf({});
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(9, 5, 1, GL_LUMINANCE, GL_FLOAT);
    for (int i = 0; i < 45; ++i)
        reinterpret_cast<float*>(image->data())[i] = static_cast<float>(i);
    osg::ref_ptr<osgTerrain::ImageLayer> layer = new osgTerrain::ImageLayer(image);
    tile->setElevationLayer(layer);
    const auto ground = tileGround(*tile);
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->tile->tile.grid().dataColumns(), 9);
    EXPECT_EQ(placed(*ground, 8, 4).z(), 44.0);
}

TEST(TileGround, KeepsHeightsOnTheEarthWithinTheReachOfItsVertices)
{
    const auto terrain = terrainOf(1, {.type = Locator::GEOCENTRIC});
    terrain->setVerticalScale(1000.0f);
    auto& tile = static_cast<osgTerrain::TerrainTile&>(*terrain->getChild(0));
    tile.setTerrain(terrain);
    const auto ground = tileGround(tile);
    EXPECT_EQ(ground->tile->tile.samples().heightM(30, 30), 40000.0f);
    const glm::dvec3 p = ground->tile->tile.position(30, 30);
    EXPECT_LT(std::abs(p.z) / ground->tile->tile.frame().vertexStepM(), 2147483647.0);
    tile.setTerrain(nullptr);
}

TEST(TileGround, TakesNumbersThatAreNoHeightsForVoids)
{
    const auto tile = tileOf({});
    auto& layer = static_cast<osgTerrain::HeightFieldLayer&>(*tile->getElevationLayer());
    layer.getHeightField()->setHeight(5, 5, -3.4e38f);
    EXPECT_TRUE(elevationSamples(*tile)->voidAt(5, 5));
}

TEST(TileGround, HasNoneWithoutLocatorOrHeights)
{
    const auto flat = tileOf({});
    flat->getLocator()->setTransform(osg::Matrixd::scale(100.0, 0.0, 1.0));
    EXPECT_FALSE(tileGround(*flat)) << "a locator without extent";
    EXPECT_FALSE(tileGround(*osg::ref_ptr<osgTerrain::TerrainTile>(new osgTerrain::TerrainTile)));
    const auto tile = tileOf({});
    tile->getElevationLayer()->setValidDataOperator(new osgTerrain::ValidRange(9000.0f, 9001.0f));
    EXPECT_FALSE(tileGround(*tile));
}

TEST(SurfaceMap, HasUnitNormalsThatPointUpAndTheLayersHeights)
{
    for (const double northM : {1920.0, -1920.0})
    {
        const auto tile = tileWithTransform(osg::Matrixd::scale(1920.0, northM, 1.0));
        const auto ground = tileGround(*tile);
        const SurfaceMap map = surfaceMap(*ground);
        for (const int at : {0, 11, 22})
        {
            const auto* texel = reinterpret_cast<const unsigned short*>(
                map.image->data(static_cast<unsigned>(at), static_cast<unsigned>(at)));
            const osg::Vec3d normal(texel[0] / 32767.5 - 1.0, texel[1] / 32767.5 - 1.0,
                                    texel[2] / 32767.5 - 1.0);
            EXPECT_NEAR(normal.length(), 1.0, 1e-3);
            EXPECT_GT(normal.z(), 0.5);
            const double height = map.heights.x() + map.heights.y() * texel[3] / 65535.0;
            EXPECT_NEAR(height, ground->samples->heights[static_cast<std::size_t>(at) * 40 + at], 0.02);
        }
    }
}
