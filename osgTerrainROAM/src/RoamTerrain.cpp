// SPDX-License-Identifier: Apache-2.0
#include <osgTerrainROAM/core/LoadTerrain.h>

#include <osgTerrainROAM/RoamTerrain>

#include "material/ImageryDrape.h"

namespace osgTerrainROAM
{

namespace
{

AtmosphereSettings atmosphereSettings(const core::RoamFile& description)
{
    AtmosphereSettings settings;
    if (description.sunAzimuthDeg)
        settings.sunDirectionWorld =
            sunDirectionFromAngles(*description.sunAzimuthDeg, *description.sunElevationDeg);
    settings.visibilityM = description.visibilityM.value_or(settings.visibilityM);
    return settings;
}

} // namespace

RoamTerrain::RoamTerrain() : RoamTerrain(nullptr, nullptr) {}

RoamTerrain::RoamTerrain(std::shared_ptr<const core::RoamTile> tile, TerrainMaterial* material)
    : _tile(std::move(tile)), _drawable(new RoamDrawable(_tile)), _material(material)
{
    if (_material) _drawable->setStateSet(_material->stateSet());
    addChild(_drawable);
    setAtmosphere(new Atmosphere);
}

RoamTerrain::RoamTerrain(const RoamTerrain& other, const osg::CopyOp& copyOp)
    : osg::Group(other, copyOp),
      _tile(other._tile),
      _drawable(new RoamDrawable(*other._drawable, copyOp)),
      _material(other._material)
{
    setChild(other.getChildIndex(other._drawable.get()), _drawable);
    setAtmosphere(other._atmosphere);
}

void RoamTerrain::setAtmosphere(Atmosphere* atmosphere)
{
    _atmosphere = atmosphere;
    setStateSet(atmosphere ? atmosphere->stateSet() : nullptr);
}

viewlod::Result<osg::ref_ptr<RoamTerrain>> makeTerrain(const core::RoamFile& description)
{
    auto placed = core::loadTile(description);
    if (!placed) return placed.error();
    const auto tile = std::make_shared<const core::RoamTile>(std::move(*placed));

    osg::ref_ptr<osg::Image> drape;
    if (!description.imagery.empty())
    {
        auto image = imageryDrape(description.imagery, tile->tile);
        if (!image) return image.error();
        drape = *image;
    }
    osg::ref_ptr<TerrainMaterial> material =
        new TerrainMaterial(tile->tile, climateOf(tile->tile, description.land), drape.get());
    osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material.get());
    terrain->setErrorTolerancePx(description.errorTolerancePx);
    terrain->setMaxTriangles(description.maxTriangles);
    terrain->setAtmosphere(new Atmosphere(atmosphereSettings(description)));
    terrain->setName(description.dem.string());
    return terrain;
}

viewlod::Result<osg::ref_ptr<RoamTerrain>> openTerrain(const std::filesystem::path& file)
{
    const auto description = core::describeTerrain(file);
    if (!description) return description.error();
    return makeTerrain(*description);
}

} // namespace osgTerrainROAM
