// SPDX-License-Identifier: Apache-2.0
#include "TerrainTechnique.h"

#include <osg/Program>
#include <osgTerrain/GeometryTechnique>
#include <osgTerrain/Layer>
#include <osgTerrain/Terrain>
#include <osgTerrain/TerrainTile>

namespace framebench
{

using osgTerrainROAM::core::PlacedTile;

namespace
{

osg::ref_ptr<osg::HeightField> heightsOf(const PlacedTile& tile)
{
    osg::ref_ptr<osg::HeightField> heights = new osg::HeightField;
    heights->allocate(static_cast<unsigned>(tile.grid().dataColumns()),
                      static_cast<unsigned>(tile.grid().dataRows()));
    heights->setXInterval(static_cast<float>(tile.field().spacingEastM));
    heights->setYInterval(static_cast<float>(tile.field().spacingNorthM));
    for (int row = 0; row < tile.grid().dataRows(); ++row)
        for (int column = 0; column < tile.grid().dataColumns(); ++column)
            heights->setHeight(static_cast<unsigned>(column), static_cast<unsigned>(row),
                               tile.samples().heightM(column, row));
    return heights;
}

} // namespace

osg::ref_ptr<osg::Node> terrainTechnique(const PlacedTile& tile,
                                         const osgTerrainROAM::TerrainMaterial* material, Look look)
{
    const double eastM = (tile.grid().dataColumns() - 1) * tile.field().spacingEastM;
    const double northM = (tile.grid().dataRows() - 1) * tile.field().spacingNorthM;
    osg::ref_ptr<osgTerrain::Locator> locator = new osgTerrain::Locator;
    locator->setCoordinateSystemType(osgTerrain::Locator::PROJECTED);
    locator->setTransformAsExtents(0.0, 0.0, eastM, northM);

    osg::ref_ptr<osgTerrain::HeightFieldLayer> layer = new osgTerrain::HeightFieldLayer(heightsOf(tile));
    layer->setLocator(locator);
    osg::ref_ptr<osgTerrain::TerrainTile> part = new osgTerrain::TerrainTile;
    part->setLocator(locator);
    part->setElevationLayer(layer);
    part->setTerrainTechnique(new osgTerrain::GeometryTechnique);
    osg::ref_ptr<osgTerrain::Terrain> terrain = new osgTerrain::Terrain;
    terrain->setSampleRatio(1.0F);
    terrain->addChild(part);

    osg::StateSet& state = *terrain->getOrCreateStateSet();
    if (material)
        state.setAttributeAndModes(plainVertexProgram(*material, look));
    else // an empty program, which replaces the one above: OSG's fixed function is drawn
        state.setAttributeAndModes(new osg::Program);
    state.addUniform(
        new osg::Uniform("benchSpacing", osg::Vec2f(static_cast<float>(tile.field().spacingEastM),
                                                    static_cast<float>(tile.field().spacingNorthM))));
    if (!material)
        for (const GLenum mode : {GL_CLIP_PLANE0, GL_CLIP_PLANE1})
            state.setMode(mode, osg::StateAttribute::OFF);
    return terrain;
}

} // namespace framebench
