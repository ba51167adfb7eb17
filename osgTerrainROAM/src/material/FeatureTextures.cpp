// SPDX-License-Identifier: Apache-2.0
#include "FeatureTextures.h"

#include <string>

#include <osg/Texture2D>
#include <osg/Uniform>

namespace osgTerrainROAM
{

namespace
{

void addTexture(osg::StateSet& stateSet, const char* name, int unit, osg::Image* image, bool filtered)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    if (image->getPixelFormat() == GL_RED)
        texture->setSwizzle(osg::Vec4i(GL_ZERO, GL_RED, GL_ZERO, GL_ZERO)); // asphalt
    texture->setFilter(osg::Texture::MIN_FILTER,
                       filtered ? osg::Texture::LINEAR_MIPMAP_LINEAR : osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, filtered ? osg::Texture::LINEAR : osg::Texture::NEAREST);
    // Beyond the border all shares are 0.
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_BORDER);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_BORDER);
    texture->setBorderColor(osg::Vec4d(0.0, 0.0, 0.0, 0.0));
    stateSet.setTextureAttributeAndModes(unit, texture);
    stateSet.addUniform(new osg::Uniform(name, unit));
}

/// Adds where the cells lie, as uniforms of names that begin with `prefix`.
void addGrid(osg::StateSet& stateSet, const FeatureMaps& maps, const std::string& prefix)
{
    osg::ref_ptr<osg::Uniform> grid = new osg::Uniform(osg::Uniform::INT_VEC4, prefix + "Grid");
    grid->set(maps.firstCell.x, maps.firstCell.y, maps.columns, maps.rows);
    stateSet.addUniform(grid);
    const std::string cellM = prefix + "CellM";
    stateSet.addUniform(new osg::Uniform(cellM.c_str(), static_cast<float>(maps.cellM)));
}

} // namespace

namespace
{

void addRunways(osg::StateSet& stateSet, const FeatureMaps& maps)
{
    const bool areAll = maps.runways.size() <= kMostRunways;
    const std::size_t count = areAll ? maps.runways.size() : 0;
    const osg::ref_ptr<osg::Uniform> ends =
        new osg::Uniform(osg::Uniform::FLOAT_VEC4, "featureRunways", kMostRunways);
    const osg::ref_ptr<osg::Uniform> halves =
        new osg::Uniform(osg::Uniform::FLOAT, "featureRunwayHalfM", kMostRunways);
    const glm::dvec2 first = glm::dvec2(maps.firstCell) * maps.cellM;
    for (unsigned int i = 0; i < count; ++i)
    {
        const glm::vec2 from(maps.runways[i].from - first), to(maps.runways[i].to - first);
        ends->setElement(i, osg::Vec4f(from.x, from.y, to.x, to.y));
        halves->setElement(i, static_cast<float>(0.5 * maps.runways[i].widthM));
    }
    stateSet.addUniform(ends);
    stateSet.addUniform(halves);
    stateSet.addUniform(new osg::Uniform("featureRunwayCount", areAll ? static_cast<int>(count) : -1));
}

} // namespace

void addFeatureTextures(osg::StateSet& stateSet, const FeatureMaps& maps, int firstUnit)
{
    addTexture(stateSet, "featureCells", firstUnit, maps.cells.get(), false);
    addTexture(stateSet, "featureRecords", firstUnit + 1, maps.records.get(), false);
    addTexture(stateSet, "featureFarCrops", firstUnit + 2, maps.crops.get(), true);
    addTexture(stateSet, "featureFarBeds", firstUnit + 3, maps.beds.get(), true);
    addGrid(stateSet, maps, "feature");
    addRunways(stateSet, maps);
    stateSet.addUniform(
        new osg::Uniform("featureFarTexelM", static_cast<float>(maps.cellM / maps.farPerCell)));
}

void addFarFeatureTexture(osg::StateSet& stateSet, const FeatureMaps& maps, int unit)
{
    addTexture(stateSet, "farFeatureBeds", unit, maps.beds.get(), true);
    addGrid(stateSet, maps, "farFeature");
}

} // namespace osgTerrainROAM
