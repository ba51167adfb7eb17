// SPDX-License-Identifier: Apache-2.0
#include "TileState.h"

#include <osg/Texture2D>
#include <osg/Uniform>

#include "SurfaceMap.h"

namespace osgTerrainROAM
{

namespace
{

void addMap(osg::StateSet& state, const char* name, unsigned int unit, osg::Image* image,
            osg::Texture::FilterMode minFilter, osg::Texture::FilterMode magFilter)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, minFilter);
    texture->setFilter(osg::Texture::MAG_FILTER, magFilter);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    state.setTextureAttribute(unit, texture);
    state.addUniform(new osg::Uniform(name, static_cast<int>(unit)));
}

void addLayers(osg::StateSet& state, const std::vector<ColourLayer>& layers)
{
    osg::ref_ptr<osg::Uniform> s = new osg::Uniform(osg::Uniform::FLOAT_VEC4, "terrainLayerS", kMostLayers);
    osg::ref_ptr<osg::Uniform> t = new osg::Uniform(osg::Uniform::FLOAT_VEC4, "terrainLayerT", kMostLayers);
    for (const ColourLayer& layer : layers)
    {
        state.setTextureAttributeAndModes(layer.unit, layer.texture);
        const std::string sampler = "terrainLayer" + std::to_string(layer.unit);
        state.addUniform(new osg::Uniform(sampler.c_str(), static_cast<int>(layer.unit)));
        s->setElement(layer.unit, layer.s);
        t->setElement(layer.unit, layer.t);
    }
    state.addUniform(s);
    state.addUniform(t);
}

} // namespace

osg::ref_ptr<osg::StateSet> tileState(const osgTerrain::TerrainTile& tile, const TileGround& ground,
                                      LayerPrograms& programs)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    const SurfaceMap map = surfaceMap(ground);
    addMap(*state, "terrainSurface", kSurfaceUnit, map.image, osg::Texture::LINEAR_MIPMAP_LINEAR,
           osg::Texture::LINEAR);
    state->addUniform(new osg::Uniform("terrainSurfaceFromGrid", map.fromGrid));
    state->addUniform(new osg::Uniform("terrainLayerHeights", map.heights));
    const osg::ref_ptr<osg::Image> holes = holeMap(*ground.samples);
    if (holes) addMap(*state, "terrainHoles", kHoleUnit, holes, osg::Texture::NEAREST, osg::Texture::NEAREST);

    const std::vector<ColourLayer> layers = colourLayers(tile, *ground.locator);
    addLayers(*state, layers);
    state->setAttributeAndModes(programs.program(layers, holes.valid()));
    const core::PlacedTile& placed = ground.tile->tile;
    state->addUniform(
        new osg::Uniform("terrainLastSample", osg::Vec2f(static_cast<float>(placed.grid().dataColumns() - 1),
                                                         static_cast<float>(placed.grid().dataRows() - 1))));
    // GL_CLIP_DISTANCE0 and 1 have the numbers of the first two clip planes.
    state->setMode(GL_CLIP_PLANE0, osg::StateAttribute::ON);
    state->setMode(GL_CLIP_PLANE1, osg::StateAttribute::ON);
    if (blends(tile))
    {
        state->setMode(GL_BLEND, osg::StateAttribute::ON);
        state->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
    }
    return state;
}

} // namespace osgTerrainROAM
