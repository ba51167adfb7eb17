// SPDX-License-Identifier: Apache-2.0
#include "worldtool/WorldMaker.h"

#include <sstream>
#include <system_error>

#include <foundation/WholeFile.h>

#include <osgRoads/core/write/WriteNetwork.h>
#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/edit/EditFile.h>

#include "scenery/roads/LayRoads.h"
#include "worldmaking/land/HouseFile.h"
#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/ModelPoints.h"
#include "worldmaking/land/Trees.h"
#include "worldtool/BuildReport.h"
#include "worldtool/RideFiles.h"

namespace worldtool
{

namespace
{

constexpr double kRoadSampleM = 3.0; ///< between samples of the ground beside roads

} // namespace

foundation::Outcome WorldMaker::make()
{
    const std::string mapName =
        _source.request.map.empty() ? "the made-up map" : _source.request.map.string();
    const auto streets = worldmaking::buildStreets(_source.streets, _ground, mapName);
    if (!streets) return streets.error();
    report.json["streets"] = rowOf(streets->report);
    if (auto written = osgRoads::core::writeNetwork(streets->network, file("roads.xodr")); !written)
        return written;
    const auto plane = worldmaking::MapPlane::create(streets->network.header, mapName);
    if (!plane) return plane.error();
    const worldmaking::RoadRoom room(streets->network);
    for (const worldmaking::Runway& runway : _source.runways)
    {
        const auto strip = worldmaking::stripOf(runway, *plane);
        if (!strip || !_ground(runway.from.y, runway.from.x) || !_ground(runway.to.y, runway.to.x)) continue;
        _runways.push_back(runway);
        _strips.push_back(*strip);
    }
    if (auto made = makeHouses(*plane, room); !made) return made;
    if (auto made = makeLand(*plane, room, streets->network.header.geoReference); !made) return made;
    if (const RideSource rides{streets->network, *plane, _source.places, _runways, _source.placeInScene};
        !_source.places.empty())
        if (auto written = writeRides(rides, _source.request.world); !written) return written;
    if (auto written = foundation::writeWholeFile(file("report.json"), report.json.dump(2) + '\n'); !written)
        return written;
    if (auto made = makeEdits(); !made) return made;
    return foundation::writeWholeFile(file("world.roam"), describe() + "edits = ground.edits\n");
}

/// Cuts the ground to the roads, so that opening the world need not.
foundation::Outcome WorldMaker::makeEdits()
{
    const auto description = osgTerrainROAM::core::parseRoamFile(describe(), file("world.roam"));
    if (!description) return description.error();
    const auto before = osgTerrainROAM::core::loadRoamTile(*description);
    if (!before) return before.error();
    const auto cut = scenery::loadRoadTile(*description);
    if (!cut) return cut.error();
    const auto source = osgTerrainROAM::core::editSourceOf(*description);
    if (!source) return source.error();
    return osgTerrainROAM::core::writeEdits(**before, *cut->tile, *source, file("ground.edits"));
}

std::optional<double> WorldMaker::heightM(const worldmaking::MapPlane& plane, const glm::dvec2& plan) const
{
    const auto place = plane.toDegrees(plan);
    return place ? _ground(place->y, place->x) : std::nullopt;
}

std::optional<worldmaking::MapBox> WorldMaker::limitIn(const worldmaking::MapPlane& plane) const
{
    if (_source.request.bounds.empty()) return std::nullopt;
    const auto low = plane.toPlan({_source.bounds.west, _source.bounds.south}),
               high = plane.toPlan({_source.bounds.east, _source.bounds.north});
    return low && high ? std::optional(worldmaking::MapBox{*low, *high}) : std::nullopt;
}

foundation::Outcome WorldMaker::makeHouses(const worldmaking::MapPlane& plane,
                                           const worldmaking::RoadRoom& room)
{
    worldmaking::HouseReport counts;
    const auto hasGround = [&](const glm::dvec2& plan) { return heightM(plane, plan).has_value(); };
    _houses = worldmaking::housesOf(_source.land, plane, {room, _strips, hasGround}, counts);
    report.json["buildings"] = rowOf(counts);
    return _houses.empty() ? foundation::success()
                           : worldmaking::writeHouses(_houses, file("buildings.gpkg"));
}

foundation::Outcome WorldMaker::makeLand(const worldmaking::MapPlane& plane,
                                         const worldmaking::RoadRoom& room, const std::string& proj)
{
    worldmaking::LandReport land;
    worldmaking::TreeReport plants;
    if (auto written = worldmaking::writeGround(_source.land, _runways, file("ground.gpkg"), land); !written)
        return written;
    _hasGround =
        land.fields + land.waters + land.waterLines + land.ways + land.railways + land.aprons + land.runways >
        0;
    const auto cover = worldmaking::coverRasterOf(_source.land, plane, limitIn(plane), land);
    _hasCover = land.coverAreas > 0;
    if (_hasCover)
        if (auto written = cover.write(file("landcover.tif"), proj); !written) return written;
    const auto models = worldmaking::writeModels(_source.land, plane, room, file("objects.gpkg"));
    if (!models) return models.error();
    _hasModels = *models > 0;
    report.json["models"] = {{"standing", *models}};
    const auto height = [&](const glm::dvec2& plan) { return heightM(plane, plan); };
    const auto trees =
        worldmaking::treesOf(_source.land, plane, {room, cover, _houses, _strips}, height, plants);
    _hasTrees = !trees.empty();
    report.json["land"] = rowOf(land, _source.unusableRunways + _source.runways.size() - _runways.size());
    report.json["trees"] = rowOf(plants);
    report.json["unused"] = land.unused;
    return _hasTrees ? worldmaking::writeTrees(trees, plane, file("trees.gpkg")) : foundation::success();
}

/// A path between the folders keeps a world usable when both are moved together.
std::string WorldMaker::describe() const
{
    std::ostringstream text;
    text << "# Made by worldtool build.\n";
    for (const auto& dem : _source.request.dems)
    {
        std::error_code failed;
        const auto relative = std::filesystem::relative(dem, _source.request.world, failed);
        text << "dem = " << (failed || relative.empty() ? std::filesystem::absolute(dem) : relative).string()
             << '\n';
    }
    text << "roads = roads.xodr\nroads_heights = file\nfinest_spacing = " << kRoadSampleM << '\n';
    if (!_houses.empty()) text << "buildings = buildings.gpkg\n";
    if (_hasTrees) text << "objects = trees.gpkg\n";
    if (_hasModels) text << "objects = objects.gpkg\n";
    if (_source.hasSea) text << "sea_level = 0\n";
    if (_hasGround) text << "features = ground.gpkg\n";
    if (_hasCover) text << "land_cover = landcover.tif\nland_cover_classes = worldcover\n";
    return text.str();
}

} // namespace worldtool
