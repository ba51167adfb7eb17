// SPDX-License-Identifier: Apache-2.0
#include "worldtool/WorldMaker.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <sstream>
#include <system_error>

#include <foundation/Threads.h>
#include <foundation/WholeFile.h>
#include <glm/geometric.hpp>

#include <osgRoads/core/write/WriteNetwork.h>
#include <osgTerrainROAM/core/LoadTerrain.h>
#include <osgTerrainROAM/core/edit/EditFile.h>

#include "scenery/roads/LayRoads.h"
#include "scenery/structures/RailTube.h"
#include "worldmaking/earth/Airfields.h"
#include "worldmaking/earth/EarthworkFile.h"
#include "worldmaking/earth/LevelWaters.h"
#include "worldmaking/earth/WaterWorks.h"
#include "worldmaking/land/HouseFile.h"
#include "worldmaking/land/LandUse.h"
#include "worldmaking/land/ModelPoints.h"
#include "worldmaking/land/ParkedAircraft.h"
#include "worldmaking/land/Structures.h"
#include "worldmaking/land/Trees.h"
#include "worldmaking/land/UntaggedLand.h"
#include "worldmaking/land/Yards.h"
#include "worldmaking/streets/Overpass.h"
#include "worldtool/BuildReport.h"
#include "worldtool/RideFiles.h"

namespace worldtool
{

namespace
{

constexpr double kRoadSampleM = 3.0; ///< between samples of the ground beside roads
constexpr double kFormationM = 5.0;  ///< width of what carries a track

} // namespace

foundation::Outcome WorldMaker::make()
{
    const std::string mapName = mapNameOf(_source.request);
    begin(kEarth);
    if (auto made = makeEarth(); !made) return made;
    begin(kStreets);
    auto streets = makeStreets(mapName);
    if (!streets) return streets.error();
    _hasRoads = !streets->network.roads.empty();
    report.json["streets"] = rowOf(streets->report);
    std::vector<std::string> notes = _source.land.notes;
    notes.insert(notes.end(), streets->report.notes.begin(), streets->report.notes.end());
    if (!notes.empty()) report.json["notes"] = notes;
    _tracks = std::move(streets->tracks);
    _footbridges = std::move(streets->footbridges);
    std::error_code ignored;
    if (!_state.has("world.roam")) std::filesystem::remove(file("world.roam"), ignored); // of other inputs
    const auto plane = worldmaking::MapPlane::create(streets->network.header, mapName);
    if (!plane) return plane.error();
    addTrackWorks(*plane);
    if (auto written = writeEarth(); !written) return written;
    if (_hasRoads)
        if (auto written = part("roads.xodr", [&](const auto& path)
                                { return osgRoads::core::writeNetwork(streets->network, path); });
            !written)
            return written;
    _land = _source.land;
    report.json["water"]["cutAway"] =
        worldmaking::cutToLevel(_land, *plane, waterWorksIn(*plane), streets->network);
    const worldmaking::RoadRoom room(streets->network);
    for (const worldmaking::Runway& runway : _runways)
        if (const auto strip = worldmaking::stripOf(runway, *plane)) _strips.push_back(*strip);
    begin(kHouses);
    if (auto made = makeHouses(*plane, room); !made) return made;
    begin(kLand);
    if (auto made = makeLand(*plane, room, streets->network.header.geoReference); !made) return made;
    if (const RideSource rides{streets->network, *plane, _source.places, _runways, _source.placeInScene};
        !_source.places.empty())
        if (auto written = writeRides(rides, _source.request.world); !written) return written;
    std::error_code failed;
    for (const char* ride : {"drive.xosc", "circuit.xosc"})
        if (!_source.places.empty() && std::filesystem::exists(file(ride), failed))
            if (auto noted = _state.note(ride); !noted) return noted;
    if (auto written = part("report.json", [&](const auto& path)
                            { return foundation::writeWholeFile(path, report.json.dump(2) + '\n'); });
        !written)
        return written;
    begin(kEdits);
    if (_hasRoads)
        if (auto made = part("ground.edits", [&](const auto&) { return makeEdits(); }); !made) return made;
    const std::string edits = _hasRoads ? "edits = ground.edits\n" : "";
    return part("world.roam",
                [&](const auto& path) { return foundation::writeWholeFile(path, describe() + edits); });
}

/// A map without streets becomes a world without roads.
foundation::Result<worldmaking::Streets> WorldMaker::makeStreets(const std::string& mapName) const
{
    if (!_source.streets.ways.empty())
        return worldmaking::buildStreets(_source.streets, _shaped, mapName, &_source.land);
    worldmaking::Streets none;
    none.network.header = worldmaking::planeAbout(_source.land);
    return none;
}

/// Cuts the ground to the roads, so that opening the world need not.
foundation::Outcome WorldMaker::makeEdits()
{
    const auto description = osgTerrainROAM::core::parseRoamFile(describe(), file("world.roam"));
    if (!description) return description.error();
    osgTerrainROAM::core::RoamFile bare = *description; // without its earthworks, which the edits hold, too
    bare.earthworks.clear();
    using Tile = foundation::Result<std::shared_ptr<osgTerrainROAM::core::RoamTile>>;
    std::optional<Tile> before;
    foundation::Threads beside;
    beside.run([&] { before = osgTerrainROAM::core::loadRoamTile(bare); });
    const auto cut = scenery::loadRoadTile(*description);
    beside.join();
    if (!*before) return before->error();
    if (!cut) return cut.error();
    const auto source = osgTerrainROAM::core::editSourceOf(*description);
    if (!source) return source.error();
    return osgTerrainROAM::core::writeEdits(***before, *cut->tile, *source, file("ground.edits"));
}

/// The works of waters in the plane of the roads, which is about the middle of the streets alone.
std::vector<osgTerrainROAM::core::Earthwork>
WorldMaker::waterWorksIn(const worldmaking::MapPlane& plane) const
{
    std::vector<osgTerrainROAM::core::Earthwork> works;
    for (auto work : _waterWorks)
        if (auto paths = plane.toPlan(work.paths); paths && !paths->empty())
        {
            work.paths = std::move(*paths);
            works.push_back(std::move(work));
        }
    return works;
}

std::optional<double> WorldMaker::heightM(const worldmaking::MapPlane& plane, const glm::dvec2& plan) const
{
    const auto place = plane.toDegrees(plan);
    return place ? _shaped(place->y, place->x) : std::nullopt;
}

/// Runways and water come first: streets, houses and woods follow the ground
/// that they have shaped.
foundation::Outcome WorldMaker::makeEarth()
{
    const auto made =
        worldmaking::MapPlane::create(worldmaking::planeAbout(_source.land), mapNameOf(_source.request));
    if (!made) return made.error();
    const auto plane = std::make_shared<const worldmaking::MapPlane>(*made);
    const foundation::HeightInPlan ground = [&](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto place = plane->toDegrees(plan);
        return place ? _ground(place->y, place->x) : std::nullopt;
    };
    const auto isOnGround = [&](const glm::dvec2& place) { return _ground(place.y, place.x).has_value(); };
    for (worldmaking::Runway& runway : worldmaking::runwaysOf(_source.land, *plane, _source.runways))
        if (isOnGround(runway.from) && isOnGround(runway.to)) _runways.push_back(std::move(runway));
    worldmaking::WaterReport water;
    worldmaking::AirfieldReport air;
    auto works = worldmaking::waterWorks(_source.land, *plane, ground, water);
    _waterWorks = works;
    for (auto& work : _waterWorks)
        work.paths = plane->toDegrees(work.paths).value_or(worldmaking::PlanRings());
    auto ofAir = worldmaking::airfieldWorks(_source.land, _runways, *plane, ground, air);
    std::move(ofAir.begin(), ofAir.end(), std::back_inserter(works));
    report.json["water"] = rowOf(water);
    report.json["airfields"] = rowOf(air);
    _earthPlane = plane;
    _works = std::move(works);
    shapeGround();
    return foundation::success();
}

/// Streets, houses and woods follow the ground that the works have shaped.
void WorldMaker::shapeGround()
{
    const foundation::HeightInPlan ground = [&](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto place = _earthPlane->toDegrees(plan);
        return place ? _ground(place->y, place->x) : std::nullopt;
    };
    const auto earth = std::make_shared<const osgTerrainROAM::core::Earthworks>(_works, 0.0, ground);
    _shaped = [bare = _ground, plane = _earthPlane, earth](double latitudeDeg,
                                                           double longitudeDeg) -> std::optional<double>
    {
        const auto height = bare(latitudeDeg, longitudeDeg);
        const auto plan = height ? plane->toPlan({longitudeDeg, latitudeDeg}) : std::nullopt;
        return plan ? std::optional(earth->heightM(*plan, *height)) : height;
    };
}

/// Cuttings and embankments of railways: where their heights leave the ground.
void WorldMaker::addTrackWorks(const worldmaking::MapPlane& plane)
{
    const std::size_t before = _works.size();
    std::vector<osgTerrainROAM::core::Earthwork> overTubes;
    for (const worldmaking::Track& track : _tracks)
    {
        if (track.place == worldmaking::StreetPlace::tunnel && !track.isInStreet)
            addTubeWorks(track, plane, overTubes);
        if (track.place != worldmaking::StreetPlace::ground || !track.isOffGround || track.isInStreet)
            continue;
        const auto degrees = plane.toDegrees({track.points});
        auto paths = degrees ? _earthPlane->toPlan(*degrees) : std::nullopt;
        if (!paths) continue;
        osgTerrainROAM::core::Earthwork work;
        work.paths = std::move(*paths);
        work.heightsM = {track.heightsM};
        work.widthM = kFormationM;
        _works.push_back(std::move(work));
    }
    std::move(overTubes.begin(), overTubes.end(), std::back_inserter(_works)); // the last: over cuttings
    if (_works.size() > before) shapeGround();
}

/// Ground over the tube of a railway: the cutting before a portal must not reach over the tube behind it, and
/// where the hill is too low for a tube, earth covers it.
void WorldMaker::addTubeWorks(const worldmaking::Track& track, const worldmaking::MapPlane& plane,
                              std::vector<osgTerrainROAM::core::Earthwork>& works) const
{
    constexpr double kBackM = scenery::kRailPortalBackM - 1.5, kNearPortalM = 30.0, kStepM = 3.0;
    constexpr double kWideM = 8.0, kSteep = 4.0, kCoverM = 0.2, kMostCoverM = 9.0;
    double lengthM = 0.0;
    for (std::size_t k = 0; k + 1 < track.points.size(); ++k)
        lengthM += glm::distance(track.points[k], track.points[k + 1]);
    osgTerrainROAM::core::Earthwork work;
    work.widthM = kWideM;
    work.slope = kSteep;
    std::vector<glm::dvec2> line;
    std::vector<double> heightsM;
    const auto finish = [&]
    {
        const auto degrees = line.size() < 2 ? std::nullopt : plane.toDegrees({line});
        if (auto paths = degrees ? _earthPlane->toPlan(*degrees) : std::nullopt)
        {
            work.paths = std::move(*paths);
            work.heightsM = {heightsM};
            works.push_back(work);
        }
        line.clear(), heightsM.clear();
    };
    double alongM = 0.0;
    for (std::size_t k = 0; k + 1 < track.points.size(); ++k)
    {
        const double pieceM = glm::distance(track.points[k], track.points[k + 1]);
        const int steps = std::max(1, static_cast<int>(pieceM / kStepM));
        for (int step = 0; step < steps; ++step)
        {
            const double share = static_cast<double>(step) / steps, s = alongM + share * pieceM;
            const double fromStartM = track.isPortalAtStart ? s : kNearPortalM,
                         fromEndM = track.isPortalAtEnd ? lengthM - s : kNearPortalM;
            const glm::dvec2 place = glm::mix(track.points[k], track.points[k + 1], share);
            const auto groundM = heightM(plane, place);
            const double roofM = std::lerp(track.heightsM[k], track.heightsM[k + 1], share) +
                                 worldmaking::kTunnelRoofM + kCoverM;
            const double portalM = std::min(fromStartM, fromEndM);
            const bool isBare = groundM && *groundM<roofM&& * groundM> roofM - kMostCoverM;
            if (groundM && portalM >= kBackM && (portalM < kNearPortalM || isBare))
            {
                line.push_back(place);
                heightsM.push_back(isBare ? roofM : *groundM);
            }
            else
                finish();
        }
        alongM += pieceM;
    }
    finish();
}

foundation::Outcome WorldMaker::writeEarth()
{
    _hasEarth = !_works.empty();
    if (!_hasEarth) return foundation::success();
    return part("earthworks.gpkg",
                [&](const auto& path) { return worldmaking::writeEarthworks(_works, *_earthPlane, path); });
}

std::optional<worldmaking::MapBox> WorldMaker::limitIn(const worldmaking::MapPlane& plane) const
{
    if (_source.request.bounds.empty())
        return _source.coverAt ? worldmaking::extentOf(_source.land, plane) : std::nullopt;
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
    if (_houses.empty()) return foundation::success();
    return part("buildings.gpkg", [&](const auto& path) { return worldmaking::writeHouses(_houses, path); });
}

/// Gives what the map says nothing of the kinds of the land-cover raster; without one, woods by rule. What is
/// made up leaves nothing open. Where houses stand close yards take the place of gardens.
void WorldMaker::fillCover(worldmaking::CoverRaster& cover, const worldmaking::MapPlane& plane,
                           const worldmaking::RoadRoom& room, worldmaking::LandReport& land) const
{
    const foundation::HeightInPlan height = [&](const glm::dvec2& plan) { return heightM(plane, plan); };
    const auto middle = plane.toDegrees({0.0, 0.0});
    const std::size_t before = cover.count(worldmaking::Cover::trees);
    if (_source.coverAt)
        cover.fillRest(
            [&](const glm::dvec2& plan)
            {
                const auto place = plane.toDegrees(plan);
                return place ? _source.coverAt(*place) : worldmaking::Cover::none;
            });
    else if (!_source.request.maps.empty() && middle)
        worldmaking::fillUntaggedLand(cover, {room, _houses, height, middle->y});
    worldmaking::layYards(cover, _houses);
    const double texelHa = 1e-4 * cover.texelM() * cover.texelM();
    land.untaggedWoodsHa = texelHa * static_cast<double>(cover.count(worldmaking::Cover::trees) - before);
    land.gardensHa = texelHa * static_cast<double>(cover.count(worldmaking::Cover::garden));
    land.yardsHa = texelHa * static_cast<double>(cover.count(worldmaking::Cover::yard));
}

foundation::Outcome WorldMaker::makeLand(const worldmaking::MapPlane& plane,
                                         const worldmaking::RoadRoom& room, const std::string& proj)
{
    worldmaking::LandReport land;
    worldmaking::TreeReport plants;
    if (auto written = worldmaking::writeGround(_land, _runways, file("ground.gpkg"), land); !written)
        return written; // and counts, so it is written in any case
    _hasGround =
        land.fields + land.waters + land.waterLines + land.ways + land.railways + land.aprons + land.runways >
        0;
    auto cover = worldmaking::coverRasterOf(_land, plane, limitIn(plane), land);
    _hasCover = land.coverAreas > 0;
    const foundation::HeightInPlan height = [&](const glm::dvec2& plan) { return heightM(plane, plan); };
    _hasCover = _hasCover || _source.coverAt;
    if (_hasCover) fillCover(cover, plane, room, land);
    if (_hasCover)
        if (auto written = part("landcover.tif", [&](const auto& path) { return cover.write(path, proj); });
            !written)
            return written;
    worldmaking::StructureReport standing;
    if (auto written = worldmaking::writeStructures(_source.land, plane,
                                                    {room, _runways, _strips, height, _tracks, _footbridges},
                                                    file("structures.gpkg"), standing);
        !written)
        return written;
    _hasStructures = standing.written > 0;
    report.json["structures"] = rowOf(standing);
    std::vector<worldmaking::LandShape> points = worldmaking::parkedAircraft(_source.land, plane);
    const std::size_t aircraft = points.size();
    const std::vector<worldmaking::LandShape>& shapes = _source.land.shapes;
    std::copy_if(shapes.begin(), shapes.end(), std::back_inserter(points), worldmaking::namesModel);
    const auto models = worldmaking::writeModels(points, plane, room, height, file("objects.gpkg"));
    if (!models) return models.error();
    _hasModels = *models > 0;
    report.json["models"] = {{"standing", *models}, {"aircraft", aircraft}};
    if (_hasModels)
        if (auto noted = _state.note("objects.gpkg"); !noted) return noted;
    begin(kTrees);
    const auto trees =
        worldmaking::treesOf(_source.land, plane, {room, cover, _houses, _strips}, height, plants);
    _hasTrees = !trees.empty();
    report.json["land"] = rowOf(land, _source.unusableRunways);
    report.json["trees"] = rowOf(plants);
    report.json["unused"] = land.unused;
    for (const auto& [name, isMade] :
         {std::pair("ground.gpkg", _hasGround), std::pair("structures.gpkg", _hasStructures)})
        if (isMade)
            if (auto noted = _state.note(name); !noted) return noted;
    if (!_hasTrees) return foundation::success();
    return part("trees.gpkg", [&](const auto& path) { return worldmaking::writeTrees(trees, plane, path); });
}

/// A path between the folders keeps a world usable when both are moved
/// together.
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
    if (_hasRoads)
        text << "roads = roads.xodr\nroads_heights = file\nfinest_spacing = " << kRoadSampleM << '\n';
    if (_source.climate)
        text << "aridity = " << _source.climate->aridity << "\ntree_line = " << _source.climate->treeLineM
             << '\n';
    if (_hasEarth) text << "earthworks = earthworks.gpkg\n";
    if (!_houses.empty()) text << "buildings = buildings.gpkg\n";
    if (_hasStructures) text << "structures = structures.gpkg\n";
    if (_hasTrees) text << "objects = trees.gpkg\n";
    if (_hasModels) text << "objects = objects.gpkg\n";
    if (_source.hasSea) text << "sea_level = 0\n";
    if (_source.water) text << "water = " << _source.water << '\n';
    if (_hasGround) text << "features = ground.gpkg\n";
    if (_hasCover) text << "land_cover = landcover.tif\nland_cover_classes = worldcover\n";
    return text.str();
}

} // namespace worldtool
