// SPDX-License-Identifier: Apache-2.0
#include "technique/ColourLayers.h"

#include <gtest/gtest.h>

#include <osg/Texture1D>

#include "TechniqueScene.h"
#include "technique/LayerShader.h"

namespace
{

using namespace osgTerrainROAM;
using namespace techniquescene;
using osgTerrain::TerrainTile;

std::vector<ColourLayer> layersOf(const TerrainTile& tile)
{
    return colourLayers(tile, *tile.getLocator());
}

osg::ref_ptr<osgTerrain::ImageLayer> imageLayer(double alpha = 1.0)
{
    return new osgTerrain::ImageLayer(imageOf({.alpha = alpha}));
}

float at(const osg::Vec4f& weights, double u, double v)
{
    return static_cast<float>(weights[0] + weights[1] * u + weights[2] * v + weights[3] * u * v);
}

} // namespace

TEST(ColourLayers, LieWhereTheirLocatorsPutThem)
{
    const auto tile = tileOf({.x0 = 1000.0, .sizeM = 500.0});
    const osg::ref_ptr<osgTerrain::ImageLayer> wide = imageLayer();
    wide->setLocator(locatorOf({.sizeM = 2000.0}));
    tile->setColorLayer(1, wide);
    const auto layers = layersOf(*tile);
    ASSERT_EQ(layers.size(), 2u);
    EXPECT_EQ(layers[1].unit, 1u);
    EXPECT_EQ(at(layers[0].s, 0.25, 0.75), 0.25f);
    EXPECT_EQ(at(layers[0].t, 0.25, 0.75), 0.75f);
    EXPECT_FLOAT_EQ(at(layers[1].s, 0.5, 0.5), 1250.0f / 2000.0f);
    EXPECT_FLOAT_EQ(at(layers[1].t, 0.5, 0.5), 250.0f / 2000.0f);
}

TEST(ColourLayers, KeepTheFiltersOfTheLayer)
{
    const auto tile = tileOf({});
    tile->getColorLayer(0)->setMinFilter(osg::Texture::NEAREST);
    tile->getColorLayer(0)->setMagFilter(osg::Texture::NEAREST);
    const auto layers = layersOf(*tile);
    EXPECT_EQ(layers[0].texture->getFilter(osg::Texture::MIN_FILTER), osg::Texture::NEAREST);
    EXPECT_EQ(layers[0].texture->getFilter(osg::Texture::MAG_FILTER), osg::Texture::NEAREST);
}

TEST(ColourLayers, OfASwitchTheActiveOneOfACompositeTheFirstWithAnImage)
{
    const auto tile = tileOf({.coloured = false});
    osg::ref_ptr<osgTerrain::SwitchLayer> choice = new osgTerrain::SwitchLayer;
    const osg::ref_ptr<osgTerrain::ImageLayer> one = imageLayer(), two = imageLayer();
    choice->addLayer(one);
    choice->addLayer(two);
    choice->setActiveLayer(1);
    osg::ref_ptr<osgTerrain::CompositeLayer> composite = new osgTerrain::CompositeLayer;
    composite->addLayer(new osgTerrain::ImageLayer);
    composite->addLayer(one);
    tile->setColorLayer(0, choice);
    tile->setColorLayer(2, composite);
    const auto layers = layersOf(*tile);
    ASSERT_EQ(layers.size(), 2u);
    EXPECT_EQ(layers[0].texture->getImage(0), two->getImage());
    EXPECT_EQ(layers[1].texture->getImage(0), one->getImage());
    EXPECT_EQ(layers[1].unit, 2u);
    for (const int active : {-1, 2})
    {
        choice->setActiveLayer(active);
        EXPECT_EQ(layersOf(*tile).size(), 1u) << active;
    }
}

TEST(ColourLayers, AContourIsLookedUpByHeight)
{
    const auto tile = tileOf({.coloured = false});
    osg::ref_ptr<osg::TransferFunction1D> colours = new osg::TransferFunction1D;
    colours->setColor(100.0f, osg::Vec4(1, 0, 0, 1));
    colours->setColor(500.0f, osg::Vec4(0, 1, 0, 1));
    const osg::ref_ptr<osgTerrain::ContourLayer> contour = new osgTerrain::ContourLayer(colours);
    tile->setColorLayer(0, contour);
    const auto layers = layersOf(*tile);
    ASSERT_EQ(layers.size(), 1u);
    EXPECT_EQ(layers[0].kind, LayerKind::contour);
    EXPECT_FLOAT_EQ(layers[0].s.x() + layers[0].s.y() * 200.0f, 0.25f);
    EXPECT_TRUE(dynamic_cast<const osg::Texture1D*>(layers[0].texture.get()));
}

TEST(ColourLayers, AnImageOfAlphaAloneLeavesTheColour)
{
    const auto tile = tileOf({.coloured = false});
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(2, 2, 1, GL_ALPHA, GL_UNSIGNED_BYTE);
    osg::ref_ptr<osgTerrain::ImageLayer> layer = new osgTerrain::ImageLayer(image);
    tile->setColorLayer(0, layer);
    EXPECT_EQ(layersOf(*tile)[0].kind, LayerKind::alpha);
}

TEST(Blending, IsThePolicysOfTileThenTerrainThenTheImages)
{
    const auto terrain = terrainOf(1, {.alpha = 0.5});
    auto& tile = static_cast<TerrainTile&>(*terrain->getChild(0));
    EXPECT_TRUE(blends(tile));
    tile.setBlendingPolicy(TerrainTile::DO_NOT_SET_BLENDING);
    EXPECT_FALSE(blends(tile));
    tile.setBlendingPolicy(TerrainTile::INHERIT);
    tile.setTerrain(terrain);
    terrain->setBlendingPolicy(TerrainTile::DO_NOT_SET_BLENDING);
    EXPECT_FALSE(blends(tile));
    const auto opaque = tileOf({});
    EXPECT_FALSE(blends(*opaque));
    opaque->setBlendingPolicy(TerrainTile::ENABLE_BLENDING);
    EXPECT_TRUE(blends(*opaque));
    tile.setTerrain(nullptr);
}

TEST(LayerPrograms, AreSharedByTilesOfTheSameLayers)
{
    LayerPrograms programs;
    const auto one = tileOf({}), two = tileOf({.x0 = 5000.0}), bare = tileOf({.coloured = false});
    const auto shared = programs.program(layersOf(*one), false);
    EXPECT_EQ(programs.program(layersOf(*two), false), shared);
    EXPECT_NE(programs.program(layersOf(*two), true), shared);
    EXPECT_NE(programs.program(layersOf(*bare), false), shared);
}
