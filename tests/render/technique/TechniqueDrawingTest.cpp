// SPDX-License-Identifier: Apache-2.0
// Our pictures of an osgTerrain scene against those of osgTerrain::GeometryTechnique, in the same light.
#include <gtest/gtest.h>

#include <osg/Fog>
#include <osg/Material>

#include "TechniquePictures.h"

namespace
{

using namespace techniquepictures;
using namespace techniquescene;
using osgTerrain::Terrain;
using osgTerrain::TerrainTile;

/// Shading is per pixel with us and per vertex with them: so far apart are pictures that show the same.
constexpr double kMostMean = 3.0, kMostFar = 0.035;

/// Largest differences over all viewpoints.
Unlikeness worst(Terrain& a, Terrain& b)
{
    Pictures ofA(&a), ofB(&b);
    Unlikeness most;
    for (const Viewpoint& viewpoint : viewpoints())
    {
        const Unlikeness found = unlikeness(*ofA.from(viewpoint), *ofB.from(viewpoint));
        most.mean = std::max(most.mean, found.mean);
        most.shareFar = std::max(most.shareFar, found.shareFar);
    }
    return most;
}

void expectAlike(Terrain& a, Terrain& b, const char* what)
{
    const Unlikeness found = worst(a, b);
    EXPECT_LT(found.mean, kMostMean) << what;
    EXPECT_LT(found.shareFar, kMostFar) << what;
}

/// The mutation: one of two scenes that look alike is changed.
void expectUnlike(Terrain& a, Terrain& b, const char* what)
{
    const Unlikeness found = worst(a, b);
    EXPECT_TRUE(found.mean > 2.0 * kMostMean || found.shareFar > 2.0 * kMostFar)
        << what << ' ' << found.mean << ' ' << found.shareFar;
}

/// Does the same to one of ours and one of stock osgTerrain's; they stay alike, and differ from ours without
/// it.
void expectRespected(const std::function<void(Terrain&)>& change, const char* what, const TileSpec& spec = {})
{
    const auto mine = ours(1.0, spec), theirs = stock(spec), unchanged = ours(1.0, spec);
    change(*mine);
    change(*theirs);
    expectAlike(*mine, *theirs, what);
    expectUnlike(*mine, *unchanged, what);
}

void addContour(TerrainTile& tile)
{
    osg::ref_ptr<osg::TransferFunction1D> colours = new osg::TransferFunction1D;
    colours->setColor(60.0f, osg::Vec4(0.2f, 0.2f, 1, 1));
    colours->setColor(300.0f, osg::Vec4(0.2f, 1, 0.2f, 1));
    colours->setColor(550.0f, osg::Vec4(1, 0.2f, 0.2f, 1));
    const osg::ref_ptr<osgTerrain::ContourLayer> contour = new osgTerrain::ContourLayer(colours);
    contour->setLocator(tile.getLocator());
    tile.setColorLayer(0, contour);
}

void addSecondLayer(TerrainTile& tile)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE);
    const unsigned char levels[] = {40, 255, 255, 40};
    for (unsigned i = 0; i < 4; ++i)
        *image->data(i % 2, i / 2) = levels[i];
    const osg::ref_ptr<osgTerrain::ImageLayer> layer = new osgTerrain::ImageLayer(image);
    layer->setLocator(locatorOf({.sizeM = 3840.0}));
    tile.setColorLayer(1, layer);
}

void cutHole(TerrainTile& tile)
{
    auto& layer = static_cast<osgTerrain::HeightFieldLayer&>(*tile.getElevationLayer());
    layer.setValidDataOperator(new osgTerrain::NoDataValue(-9999.0f));
    for (unsigned row = 0; row < 65; ++row)
        for (unsigned column = 0; column < 65; ++column)
            if ((row - 32.0) * (row - 32.0) + (column - 30.0) * (column - 30.0) < 400.0)
                layer.getHeightField()->setHeight(column, row, -9999.0f);
}

} // namespace

TEST(TechniqueDrawing, LooksAsGeometryTechniqueDoes)
{
    for (const TileSpec& spec : {TileSpec{}, TileSpec{.coloured = false}, TileSpec{.columns = 50, .rows = 41},
                                 TileSpec{.alpha = 0.5}})
        expectAlike(*ours(1.0, spec), *stock(spec), "plain");
}

TEST(TechniqueDrawing, AnotherGroundAnotherImageryOrNoLightWouldShow)
{
    expectUnlike(*ours(1.0, {.x0 = 300.0}), *stock(), "ground");
    expectUnlike(*ours(1.0, {.coloured = false}), *stock(), "imagery");
    expectUnlike(*ours(1.0, {.alpha = 0.5}), *stock(), "alpha");
    const auto unlit = ours();
    unlit->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    expectUnlike(*unlit, *stock(), "light");
}

TEST(TechniqueDrawing, RespectsScaleAndLayers)
{
    expectRespected([](Terrain& terrain) { terrain.setVerticalScale(1.6f); }, "vertical scale");
    expectRespected([](Terrain& terrain) { forEachTile(terrain, addContour); }, "contours");
    expectRespected([](Terrain& terrain) { forEachTile(terrain, addSecondLayer); }, "second layer");
    expectRespected([](Terrain& terrain) { forEachTile(terrain, cutHole); }, "voids");
    expectRespected(
        [](Terrain& terrain)
        {
            forEachTile(terrain, addContour);
            terrain.setVerticalScale(0.5f);
        },
        "contours are of the unscaled height");
}

TEST(TechniqueDrawing, RespectsTheScenesLightMaterialAndFog)
{
    expectRespected([](Terrain& terrain)
                    { terrain.getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF); },
                    "lighting off");
    expectRespected(
        [](Terrain& terrain)
        {
            osg::ref_ptr<osg::Material> material = new osg::Material;
            material->setDiffuse(osg::Material::FRONT_AND_BACK, osg::Vec4(0.3f, 0.3f, 1.0f, 1.0f));
            material->setAmbient(osg::Material::FRONT_AND_BACK, osg::Vec4(0.6f, 0.0f, 0.0f, 1.0f));
            terrain.getOrCreateStateSet()->setAttributeAndModes(material);
        },
        "material");
    for (const osg::Fog::Mode mode : {osg::Fog::LINEAR, osg::Fog::EXP, osg::Fog::EXP2})
        expectRespected(
            [mode](Terrain& terrain)
            {
                osg::ref_ptr<osg::Fog> fog = new osg::Fog;
                fog->setMode(mode);
                fog->setStart(500.0f);
                fog->setEnd(4000.0f);
                fog->setDensity(0.0006f);
                fog->setColor({0.2f, 0.4f, 0.9f, 1.0f});
                terrain.getOrCreateStateSet()->setAttributeAndModes(fog);
            },
            "fog");
}

TEST(TechniqueDrawing, RespectsTheBlendingPolicy)
{
    expectRespected([](Terrain& terrain) { terrain.setBlendingPolicy(TerrainTile::DO_NOT_SET_BLENDING); },
                    "policy", {.alpha = 0.5});
}

TEST(TechniqueDrawing, IsDrawnOnTheEarthAsGeometryTechniqueDoes)
{
    const TileSpec spec{.type = osgTerrain::Locator::GEOCENTRIC};
    const auto mine = ours(1.0, spec), theirs = stock(spec);
    osg::Matrixd frame;
    osg::EllipsoidModel().computeLocalToWorldTransformFromLatLongHeight(
        osg::DegreesToRadians(46.0), osg::DegreesToRadians(8.0), 0.0, frame);
    Pictures ofMine(mine), ofTheirs(theirs);
    for (const Viewpoint& viewpoint : viewpoints())
    {
        osg::ref_ptr<osg::Image> pictures[2];
        for (int i = 0; i < 2; ++i)
        {
            auto& viewer = (i == 0 ? ofMine : ofTheirs).viewer();
            viewer.camera().setViewMatrix(
                osg::Matrixd::inverse(frame) *
                osg::Matrixd::lookAt(viewpoint.eye, viewpoint.target, osg::Vec3d(0, 0, 1)));
            pictures[i] = viewer.picture();
        }
        const Unlikeness found = unlikeness(*pictures[0], *pictures[1]);
        EXPECT_LT(found.mean, kMostMean);
        EXPECT_LT(found.shareFar, kMostFar);
        EXPECT_LT(magentaPixels(*pictures[0]), 0.95 * kWidthPx * kHeightPx);
    }
}

TEST(TechniqueDrawing, ADirtyTileIsDrawnAnewAndReleasedBuffersAreFilledAgain)
{
    const auto mine = ours(), expected = ours();
    Pictures pictures(mine);
    const Viewpoint viewpoint = viewpoints().front();
    const auto before = pictures.from(viewpoint);
    mine->releaseGLObjects();
    EXPECT_EQ(unlikeness(*pictures.from(viewpoint), *before).mean, 0.0);
    const auto change = [](TerrainTile& tile)
    {
        addContour(tile);
        tile.setDirtyMask(TerrainTile::IMAGERY_DIRTY);
    };
    forEachTile(*mine, change);
    forEachTile(*expected, change);
    EXPECT_EQ(unlikeness(*pictures.from(viewpoint), *Pictures(expected).from(viewpoint)).mean, 0.0);
    EXPECT_GT(unlikeness(*pictures.from(viewpoint), *before).mean, 5.0);
}
