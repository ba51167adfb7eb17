// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <osg/Texture2D>
#include <osg/Uniform>

#include <osgTerrainROAM/TerrainMaterial>

#include "material/FeatureTextures.h"
#include "material/GrainImage.h"
#include "material/LandMap.h"
#include "material/MapGrid.h"
#include "material/NormalMap.h"
#include "material/TerrainShader.h"

namespace osgTerrainROAM
{

namespace
{

void addTexture(osg::StateSet& stateSet, const char* name, TerrainMaterial::Unit unit, osg::Image* image,
                osg::Texture::WrapMode wrap)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR_MIPMAP_LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, wrap);
    texture->setWrap(osg::Texture::WRAP_T, wrap);
    stateSet.setTextureAttributeAndModes(unit, texture);
    stateSet.addUniform(new osg::Uniform(name, static_cast<int>(unit)));
}

/// Takes grid places to texture coordinates of a map whose first and last texel centres are first and last sample.
osg::Vec4f mapFromGrid(double texelsPerSample, double offsetTexels, int side, bool wide)
{
    const auto scale = static_cast<float>(texelsPerSample / side);
    const auto offset = static_cast<float>(offsetTexels / side);
    return wide ? osg::Vec4f(scale, 0, offset, 0) : osg::Vec4f(0, scale, 0, offset);
}

} // namespace

TerrainMaterial::TerrainMaterial(const core::PlacedTile& tile, const Climate& climate, osg::Image* drapeImage)
    : _climate(climate), _hasDrape(drapeImage != nullptr), _stateSet(new osg::StateSet)
{
    addMaps(tile, drapeImage);
    addScales(tile);
    addColours();
    addClipping(tile);
    setProgram();
    // The ground has no underside, and a far slope must not win against the near one in the depth buffer's last step.
    _stateSet->setMode(GL_CULL_FACE, osg::StateAttribute::ON);
}

void TerrainMaterial::setProgram()
{
    _stateSet->setAttributeAndModes(terrainProgram({_hasDrape, _hasFeatures}));
}

void TerrainMaterial::setFeatures(const core::FeatureCells& cells)
{
    addFeatureTextures(*_stateSet, cells, features);
    const auto add = [&](const char* name, int index, const osg::Vec3f& albedo)
    {
        _stateSet->getOrCreateUniform(name, osg::Uniform::FLOAT_VEC3, 4)
            ->setElement(static_cast<unsigned>(index), albedo);
    };
    add("featureCrops", 0, {0.150f, 0.165f, 0.050f});
    add("featureCrops", 1, {0.075f, 0.120f, 0.030f});
    add("featureCrops", 2, {0.090f, 0.145f, 0.035f});
    add("featureCrops", 3, {0.045f, 0.075f, 0.022f});
    _stateSet->addUniform(new osg::Uniform("featureSoil", osg::Vec3f(0.135f, 0.105f, 0.075f)));
    _hasFeatures = true;
    setProgram();
}

void TerrainMaterial::addMaps(const core::PlacedTile& tile, osg::Image* drapeImage)
{
    const MapGrid grid(tile);
    const osg::ref_ptr<osg::Image> normalImage = normalMap(tile, grid);
    const osg::ref_ptr<osg::Image> landImage = landMap(tile, grid, _climate, *normalImage);
    addTexture(*_stateSet, "terrainNormals", normals, normalImage.get(), osg::Texture::CLAMP_TO_EDGE);
    addTexture(*_stateSet, "terrainLand", land, landImage.get(), osg::Texture::CLAMP_TO_EDGE);
    addTexture(*_stateSet, "terrainGrain", grain, grainImage().get(), osg::Texture::REPEAT);
    const double perSample = 1.0 / grid.step;
    _stateSet->addUniform(
        new osg::Uniform("terrainMapFromGrid", mapFromGrid(perSample, 0.5, grid.width, true) +
                                                   mapFromGrid(perSample, 0.5, grid.height, false)));
    if (drapeImage)
    {
        addTexture(*_stateSet, "terrainDrape", drape, drapeImage, osg::Texture::CLAMP_TO_EDGE);
        const double perColumn = (drapeImage->s() - 1.0) / (tile.dataColumns() - 1.0);
        const double perRow = (drapeImage->t() - 1.0) / (tile.dataRows() - 1.0);
        _stateSet->addUniform(
            new osg::Uniform("terrainDrapeFromGrid", mapFromGrid(perColumn, 0.5, drapeImage->s(), true) +
                                                         mapFromGrid(perRow, 0.5, drapeImage->t(), false)));
    }
}

void TerrainMaterial::addScales(const core::PlacedTile& tile)
{
    // Bumps that the data themselves show are not invented a second time: a layer counts where its features, an
    // eighth of its period, are finer than two samples.
    const double spacingM = 0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM);
    const auto finer = [=](double periodM)
    { return static_cast<float>(std::clamp((2.0 * spacingM - periodM / 8.0) / spacingM, 0.0, 1.0)); };
    _stateSet->addUniform(
        new osg::Uniform("terrainBumpiness",
                         osg::Vec4f(0.55f * std::max(finer(2.0), 0.8f), 0.45f * std::max(finer(28.0), 0.3f),
                                    0.40f * finer(324.0), 0.35f * finer(1831.0))));
    // A beach some 25 m wide, within the two samples that the water mask slopes over.
    _stateSet->addUniform(new osg::Uniform(
        "terrainShore",
        static_cast<float>(std::clamp(0.5 - 0.69 * 25.0 / std::max(spacingM, 0.1), 0.05, 0.42))));
}

void TerrainMaterial::addColours()
{
    const auto dry = static_cast<float>(std::clamp((_climate.aridity - 0.15) / 0.7, 0.0, 1.0));
    const auto add = [&](const char* name, const osg::Vec3f& humid, const osg::Vec3f& arid)
    { _stateSet->addUniform(new osg::Uniform(name, humid * (1.0f - dry) + arid * dry)); };
    // Albedos, linear.
    add("terrainRock", {0.200f, 0.190f, 0.180f}, {0.300f, 0.175f, 0.110f});
    add("terrainSoil", {0.175f, 0.150f, 0.115f}, {0.370f, 0.245f, 0.155f});
    add("terrainDryGrass", {0.165f, 0.165f, 0.070f}, {0.330f, 0.260f, 0.150f});
    add("terrainMeadow", {0.085f, 0.130f, 0.032f}, {0.200f, 0.190f, 0.095f});
    add("terrainForest", {0.032f, 0.056f, 0.022f}, {0.080f, 0.095f, 0.045f});
    add("terrainSand", {0.380f, 0.320f, 0.225f}, {0.420f, 0.330f, 0.220f});
    add("terrainSnow", {0.800f, 0.830f, 0.880f}, {0.800f, 0.830f, 0.880f});
    add("terrainWater", {0.012f, 0.040f, 0.055f}, {0.015f, 0.045f, 0.055f});
    _stateSet->addUniform(new osg::Uniform("terrainStrata", 0.10f + 0.22f * dry));
}

void TerrainMaterial::addClipping(const core::PlacedTile& tile)
{
    _stateSet->addUniform(
        new osg::Uniform("terrainLastSample", osg::Vec2f(static_cast<float>(tile.dataColumns() - 1),
                                                         static_cast<float>(tile.dataRows() - 1))));
    // GL_CLIP_DISTANCE0 and 1 have the numbers of the first two clip planes.
    _stateSet->setMode(GL_CLIP_PLANE0, osg::StateAttribute::ON);
    _stateSet->setMode(GL_CLIP_PLANE1, osg::StateAttribute::ON);
}

} // namespace osgTerrainROAM
