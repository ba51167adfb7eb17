// SPDX-License-Identifier: Apache-2.0
#include <shared_mutex>

#include <osg/Notify>

#include <osgTerrainROAM/core/LoadTerrain.h>

#include <osgTerrainROAM/FirstLook>
#include <osgTerrainROAM/RoamTerrain>
#include <osgTerrainROAM/Serializers>

#include "material/ImageryDrape.h"
#include "material/PaintFeatures.h"
#include "material/VoidImagery.h"
#include "surroundings/Surroundings.h"

namespace osgTerrainROAM
{

namespace
{

[[maybe_unused]] const bool kAreTerrainSerializersRegistered = registerSerializers();

osgSky::AtmosphereSettings atmosphereSettings(const core::RoamFile& description)
{
    osgSky::AtmosphereSettings settings;
    if (description.sunAzimuthDeg)
        settings.sunDirectionWorld =
            osgSky::sunDirectionFromAngles(*description.sunAzimuthDeg, *description.sunElevationDeg);
    settings.visibilityM = description.visibilityM.value_or(settings.visibilityM);
    settings.moonlight = description.moonlight.value_or(settings.moonlight);
    return settings;
}

/// Lays imagery in several resolutions over the tile; one alone is the material's drape.
foundation::Outcome layImagery(TerrainMaterial& material, const core::RoamFile& description,
                               const core::PlacedTile& tile)
{
    if (description.imagery.size() < 2 && !description.showsVoids) return foundation::success();
    std::vector<ImageryLayer> layers;
    if (description.showsVoids)
        if (ImageryLayer voids = voidImagery(tile); voids.image) layers.push_back(std::move(voids));
    for (const std::filesystem::path& file : description.imagery)
    {
        auto layer = imageryLayer(file, tile);
        if (!layer) return layer.error();
        layers.push_back(std::move(*layer));
    }
    return layers.empty() ? foundation::success() : material.setImagery(std::move(layers));
}

/// Imports the land cover, if there is one, and gives it to the material.
foundation::Outcome coverGround(TerrainMaterial& material, const core::RoamFile& description,
                                const core::PlacedTile& tile)
{
    if (description.landCover.empty()) return foundation::success();
    const auto table = core::readCoverTable(description.landCoverClasses);
    if (!table) return table.error();
    const auto map = core::importCover(description.landCover, *table, tile, material.kept());
    if (!map) return map.error();
    for (const auto& [code, count] : map->unknownCodes)
        osg::notify(osg::NOTICE) << description.landCover.string() << ": class " << code
                                 << " has no kind in its table, " << count << " texels" << std::endl;
    for (const std::string& note : map->notes)
        osg::notify(osg::NOTICE) << note << std::endl;
    material.setCover(*map);
    return foundation::success();
}

} // namespace

RoamTerrain::RoamTerrain() : RoamTerrain(std::shared_ptr<const core::RoamTile>(), nullptr) {}

RoamTerrain::RoamTerrain(std::shared_ptr<const core::RoamTile> tile, TerrainMaterial* material)
    : _tile(std::move(tile)), _drawable(new RoamDrawable(_tile)), _material(material)
{
    if (_material) _drawable->setStateSet(_material->stateSet());
    addChild(_drawable);
    setAtmosphere(new osgSky::Atmosphere);
}

RoamTerrain::RoamTerrain(const std::shared_ptr<core::RoamTile>& tile, TerrainMaterial* material)
    : RoamTerrain(std::shared_ptr<const core::RoamTile>(tile), material)
{
    _editor = std::make_shared<core::GroundEditor>(tile);
    setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
}

RoamTerrain::RoamTerrain(const RoamTerrain& other, const osg::CopyOp& copyOp)
    : osg::Group(other, copyOp),
      _tile(other._tile),
      _editor(other._editor),
      _revision(other._revision),
      _source(other._source),
      _drawable(new RoamDrawable(*other._drawable, copyOp)),
      _material(other._material),
      _surroundings(other._surroundings),
      _featureReport(other._featureReport)
{
    setChild(other.getChildIndex(other._drawable.get()), _drawable);
    if (_surroundings) setChild(other.getChildIndex(_surroundings), _surroundings);
    setAtmosphere(other._atmosphere);
    if (_editor) setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
}

/// Shows the terrain of another node, which is dropped afterwards: its drawable has one owner.
void RoamTerrain::takeContents(const RoamTerrain& other)
{
    if (other._editor && !_editor)
        setNumChildrenRequiringUpdateTraversal(getNumChildrenRequiringUpdateTraversal() + 1);
    _tile = other._tile;
    _editor = other._editor;
    _revision = other._revision;
    _source = other._source;
    _material = other._material;
    _featureReport = other._featureReport;
    setChild(getChildIndex(_drawable.get()), other._drawable.get());
    _drawable = other._drawable;
    setAtmosphere(other._atmosphere);
    if (_surroundings) removeChild(_surroundings);
    _surroundings = other._surroundings;
    if (_surroundings) addChild(_surroundings);
    setCullingActive(!_surroundings);
}

void RoamTerrain::showSurroundings(bool on)
{
    if (on == showsSurroundings() || !_tile || !_material) return;
    if (on)
    {
        const std::shared_lock lock(_tile->mutex());
        _surroundings = new Surroundings(_tile, _material);
        addChild(_surroundings);
    }
    else
    {
        removeChild(_surroundings);
        _surroundings = nullptr;
    }
    _drawable->closeEdge(on);
    // They reach beyond the bounds of the node.
    setCullingActive(!on);
}

void RoamTerrain::traverse(osg::NodeVisitor& visitor)
{
    if (visitor.getVisitorType() == osg::NodeVisitor::UPDATE_VISITOR) followEdits();
    osg::Group::traverse(visitor);
}

core::GroundEditor* RoamTerrain::editor() const
{
    return core::traitsOf(settings().method).followsEdits ? _editor.get() : nullptr;
}

void RoamTerrain::followEdits()
{
    if (!_editor) return;
    std::vector<core::GridRect> moved;
    {
        const std::shared_lock lock(_tile->mutex());
        if (_tile->revision() == _revision) return;
        const auto changes = _tile->changesSince(_revision);
        _revision = _tile->revision();
        if (!changes) moved.push_back({0, 0, _tile->tile.grid().side() - 1, _tile->tile.grid().side() - 1});
        for (const core::TileChange* change : changes.value_or(std::vector<const core::TileChange*>()))
            moved.insert(moved.end(), change->moved.begin(), change->moved.end());
        if (_material) _material->followEdits(_tile->tile, moved);
    }
    _drawable->followEdits(moved);
}

void RoamTerrain::setAtmosphere(osgSky::Atmosphere* atmosphere)
{
    _atmosphere = atmosphere;
    setStateSet(atmosphere ? atmosphere->stateSet() : nullptr);
}

foundation::Result<osg::ref_ptr<RoamTerrain>> makeTerrain(const core::RoamFile& description)
{
    const auto tile = core::loadRoamTile(description);
    if (!tile) return tile.error();
    return makeTerrain(description, *tile);
}

foundation::Result<osg::ref_ptr<RoamTerrain>> makeTerrain(const core::RoamFile& description,
                                                          const std::shared_ptr<core::RoamTile>& tile,
                                                          const MoreFeatures& more,
                                                          const foundation::KeptFrom& kept)
{
    osg::ref_ptr<osg::Image> drape;
    if (description.imagery.size() == 1 && !description.showsVoids)
    {
        auto image = imageryDrape(description.imagery.front(), tile->tile);
        if (!image) return image.error();
        drape = *image;
    }
    osg::ref_ptr<TerrainMaterial> material =
        new TerrainMaterial(tile->tile, climateOf(tile->tile, description.land), drape.get(), kept);
    if (const auto laid = layImagery(*material, description, tile->tile); !laid) return laid.error();
    if (const auto covered = coverGround(*material, description, tile->tile); !covered)
        return covered.error();
    if (description.seasonOfYear)
        if (const auto set = material->setSeason(description.seasonOfYear); !set) return set.error();
    const auto features = paintFeatures(*material, description, tile->tile, more);
    if (!features) return features.error();
    osg::ref_ptr<RoamTerrain> terrain = new RoamTerrain(tile, material.get());
    terrain->setFeatureReport(*features);
    RoamDrawableSettings settings;
    settings.method = description.method;
    settings.errorTolerancePx = description.errorTolerancePx;
    settings.maxTriangles = description.maxTriangles;
    settings.viewMarginDeg = description.viewMarginDeg;
    settings.maxAdaptTimeUs = description.adaptTimeUs.value_or(settings.maxAdaptTimeUs);
    if (const auto set = terrain->setSettings(settings); !set) return set.error();
    if (const auto set = terrain->atmosphere()->setSettings(atmosphereSettings(description)); !set)
        return set.error();
    terrain->showSurroundings(description.surroundings);
    terrain->setName(description.dems.empty() ? tile->tile.field().name : description.dems.front().string());
    return terrain;
}

foundation::Result<osg::ref_ptr<RoamTerrain>> openTerrain(const std::filesystem::path& file)
{
    const auto description = core::describeTerrain(file);
    if (!description) return description.error();
    auto terrain = makeTerrain(*description);
    if (!terrain) return terrain;
    (*terrain)->setSource(std::filesystem::absolute(file));
    (*terrain)->addEventCallback(new FirstLook);
    return terrain;
}

} // namespace osgTerrainROAM
