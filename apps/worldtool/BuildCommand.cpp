// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>
#include <utility>

#include <osgTerrainROAM/core/Climate.h>
#include <osgTerrainROAM/core/cover/CoverTable.h>
#include <osgTerrainROAM/core/heightfield/DemCheck.h>

#include "worldmaking/land/Runways.h"
#include "worldmaking/land/TagReport.h"
#include "worldmaking/madeup/MadeUpMap.h"
#include "worldmaking/map/ReadLand.h"
#include "worldmaking/plan/Waters.h"
#include "worldtool/BuildReport.h"
#include "worldtool/BuildState.h"
#include "worldtool/Commands.h"
#include "worldtool/EarthGround.h"
#include "worldtool/LandCover.h"
#include "worldtool/ReadMap.h"
#include "worldtool/WorldMaker.h"

namespace worldtool
{

namespace
{

using worldmaking::MapBounds;

foundation::Result<MapBounds> boundsOf(const Request& request)
{
    const auto& b = request.bounds;
    if (b.empty()) return MapBounds();
    if (!(b[0] < b[2] && b[1] < b[3]) || std::abs(b[1]) > 90.0 || std::abs(b[3]) > 90.0)
        return foundation::Error{"--bounds", "is no rectangle", "give WEST,SOUTH,EAST,NORTH in degrees"};
    return MapBounds{b[0], b[1], b[2], b[3]};
}

bool overlap(const MapBounds& a, const MapBounds& b)
{
    return a.west < b.east && b.west < a.east && a.south < b.north && b.south < a.north;
}

/// Errors: the bounds lie beside the elevation data.
foundation::Outcome checkOnGround(const Request& request, const MapBounds& bounds, const MapBounds& ground)
{
    if (request.bounds.empty() || overlap(bounds, ground)) return foundation::success();
    const MapBounds swapped{bounds.south, bounds.west, bounds.north, bounds.east};
    char extent[120], other[160];
    std::snprintf(extent, sizeof extent, "%.5g,%.5g,%.5g,%.5g", ground.west, ground.south, ground.east,
                  ground.north);
    std::snprintf(other, sizeof other, "longitude comes first; did you mean %.9g,%.9g,%.9g,%.9g?",
                  swapped.west, swapped.south, swapped.east, swapped.north);
    return foundation::Error{"--bounds", std::string("lies beside the elevation data, which is in ") + extent,
                             overlap(swapped, ground) ? other : "give WEST,SOUTH,EAST,NORTH within it"};
}

/// A folder that was made for a world and is empty at the end is removed.
class WorldFolder
{
public:
    explicit WorldFolder(std::filesystem::path folder) : _folder(std::move(folder))
    {
        std::error_code ignored;
        _isNew = !std::filesystem::exists(_folder, ignored);
    }
    ~WorldFolder()
    {
        std::error_code ignored;
        if (_isNew) std::filesystem::remove(_folder, ignored); // fails where anything is in it
    }
    WorldFolder(const WorldFolder&) = delete;
    WorldFolder& operator=(const WorldFolder&) = delete;

private:
    std::filesystem::path _folder;
    bool _isNew = false;
};

worldmaking::MadeUpSettings settingsOf(const Request& request, const MapBounds& ground)
{
    worldmaking::MadeUpSettings settings;
    settings.seed = request.seed;
    const auto climate = osgTerrainROAM::core::climateAt(0.5 * (ground.south + ground.north),
                                                         0.5 * (ground.west + ground.east));
    settings.aridity = request.aridity.value_or(climate.aridity);
    settings.treeLineM = climate.treeLineM;
    settings.bounds = ground;
    if (const auto& b = request.bounds; !b.empty())
        settings.bounds = {std::max(b[0], ground.west), std::max(b[1], ground.south),
                           std::min(b[2], ground.east), std::min(b[3], ground.north)};
    return settings;
}

void tell(const nlohmann::ordered_json& report, const Request& request)
{
    std::cout << summaryOf(report) << "all counts: " << (request.world / "report.json").string() << '\n';
}

/// The files of the map, and the runways of a table.
struct InputHeads
{
    std::vector<worldmaking::MapSource> maps;
    worldmaking::RunwayTable runways;
};

/// Reads of the inputs what is read in no time, so that what is wrong with it is told before any work.
foundation::Result<InputHeads> readHeads(const Request& request)
{
    InputHeads listed;
    auto maps = worldmaking::mapSourcesOf(request.maps);
    if (!maps) return maps.error();
    listed.maps = std::move(*maps);
    if (const auto usable = osgTerrainROAM::core::checkDems(request.dems); !usable) return usable.error();
    if (!request.landCover.empty())
        if (const auto table = osgTerrainROAM::core::readCoverTable(request.landCoverClasses); !table)
            return table.error();
    if (request.runways.empty()) return listed;
    auto read = worldmaking::readRunways(request.runways);
    if (!read) return read.error();
    listed.runways = std::move(*read);
    return listed;
}

/// Tells on a line each how the map was joined, and which of its tags are not taken as they stand; and puts
/// it into the report.
void tellOfMap(const WholeMap& map, const std::string& name, nlohmann::ordered_json& report)
{
    const worldmaking::JoinReport& joined = map.joined;
    if (joined.isJoined || joined.files > 1)
    {
        report["map"] = {{"files", joined.files},           {"objects", joined.objects},
                         {"repeated", joined.repeated},     {"deleted", joined.deleted},
                         {"renumbered", joined.renumbered}, {"middles", joined.middles}};
        const std::string done =
            joined.files == 1 ? "put in order" : "joined from " + std::to_string(joined.files) + " files";
        std::cerr << "worldtool: " << name << ": " << done << "; " << joined.repeated
                  << " states of objects are repeated or older, " << joined.deleted
                  << " objects are deleted\n";
    }
    if (joined.middles > 0)
        std::cerr
            << "worldtool: " << name << ": " << joined.middles
            << " ways and relations have a middle alone (Overpass, out center) and are passed over; ask "
               "Overpass for out geom\n";
    const worldmaking::TagReport tags = worldmaking::tagReportOf(map.land);
    report["tags"] = {{"passedOver", tags.passedOver}, {"approximated", tags.approximated}};
    const auto tell = [&](const worldmaking::TagCounts& counts, const char* what)
    {
        if (!counts.empty())
            std::cerr << "worldtool: " << name << ": " << what << worldmaking::lineOf(counts) << '\n';
    };
    tell(tags.passedOver, "values that cannot be read are passed over: ");
    tell(tags.approximated, "tags of streets that are approximated: ");
}

/// What a made-up map has beside its land and streets.
struct MadeUpLand
{
    std::vector<worldmaking::Runway> runways;
    std::vector<worldmaking::MadeUpPlace> places;
    std::optional<WorldClimate> climate; ///< absent: that of the place
    bool hasSea = false;
    nlohmann::ordered_json report;
};

/// Makes up a map on the ground; its land and streets go into @p map.
/// Errors: those of makeUpMap().
foundation::Result<MadeUpLand> makeUp(const Request& request, const EarthGround& ground, WholeMap& map)
{
    const auto settings = settingsOf(request, ground.bounds);
    auto made = worldmaking::makeUpMap(ground.heightM, settings);
    if (!made) return made.error();
    map.land = std::move(made->land);
    map.streets = worldmaking::streetsOf(map.land);
    return MadeUpLand{std::move(made->runways), std::move(made->places),
                      WorldClimate{settings.aridity, made->treeLineM}, made->hasSea, rowOf(made->report)};
}

nlohmann::ordered_json rowsOf(const std::vector<worldmaking::MadeUpPlace>& places)
{
    auto rows = nlohmann::ordered_json::array();
    for (const worldmaking::MadeUpPlace& place : places)
        rows.push_back(
            {{"kind", place.kind}, {"longitudeDeg", place.degrees.x}, {"latitudeDeg", place.degrees.y}});
    return rows;
}

/// The report of a world that is made of the same inputs already. Its files become new, as those who make
/// worlds by rules expect.
Report keptReport(const Request& request)
{
    std::error_code ignored;
    for (const char* name : {"world.roam", "drive.xosc", "circuit.xosc"})
        if (const auto file = request.world / name; std::filesystem::exists(file, ignored))
            std::filesystem::last_write_time(file, std::filesystem::file_time_type::clock::now(), ignored);
    Report made;
    std::ifstream stream(request.world / "report.json");
    made.json = nlohmann::ordered_json::parse(stream, nullptr, false);
    std::cerr << "worldtool: " << request.world.string() << " is made of these inputs already\n";
    tell(made.json, request);
    return made;
}

/// Level ground is no lake where the map tells what water there is: villages stood in water on a delta whose
/// heights are whole metres.
const char* waterOf(const worldmaking::LandMap& land, bool isMadeUp, bool hasSea)
{
    if (isMadeUp) return hasSea ? "sea" : "none";
    return std::any_of(land.shapes.begin(), land.shapes.end(), worldmaking::isWater) ? "sea" : nullptr;
}

} // namespace

terminal::Places placesOf(const Request& request)
{
    terminal::Places places;
    places.folders = {{request.world, "build.json"}};
    places.read = {request.runways, request.landCover};
    for (const auto& map : request.maps)
    {
        std::error_code ignored;
        const bool isOfGdal = map.string().starts_with("/vsi");
        if (!isOfGdal && !std::filesystem::is_directory(map, ignored)) places.read.push_back(map);
    }
    return places;
}

std::string mapNameOf(const Request& request)
{
    if (request.maps.empty()) return "the made-up map";
    const std::size_t others = request.maps.size() - 1;
    return request.maps.front().string() + (others > 0 ? " and " + std::to_string(others) + " more" : "");
}

foundation::Result<Report> build(const Request& request)
{
    const auto bounds = boundsOf(request);
    if (!bounds) return bounds.error();
    const auto listed = readHeads(request);
    if (!listed) return listed.error();
    const WorldFolder folder(request.world);
    std::error_code failed;
    std::filesystem::create_directories(request.world, failed);
    if (failed)
        return foundation::Error{request.world.string(), "cannot be made: " + failed.message(),
                                 "name a folder that can be written"};
    auto state = BuildState::open(request);
    if (!state) return state.error();
    if (state->isWhole()) return keptReport(request);
    terminal::Progress progress("worldtool", 100);
    progress.begin(kGround.name, kGround.share);
    const auto ground = loadGround(request.dems);
    if (!ground) return ground.error();
    if (const auto on = checkOnGround(request, *bounds, ground->bounds); !on) return on.error();
    auto cover = coverOf(request, *ground);
    if (!cover) return cover.error();
    progress.begin(kMap.name, kMap.share);
    const bool isMadeUp = request.maps.empty();
    auto map = isMadeUp ? foundation::Result<WholeMap>(WholeMap())
                        : readMap(listed->maps, request.world, *bounds, ground->bounds);
    if (!map) return map.error();
    if (!isMadeUp && map->streets.ways.empty() && !map->isOn(*ground))
        return foundation::Error{mapNameOf(request), "nothing in it lies on the elevation data",
                                 "give a map and elevation data of the same region"};
    auto made = isMadeUp ? makeUp(request, *ground, *map) : foundation::Result<MadeUpLand>(MadeUpLand());
    if (!made) return made.error();
    std::vector<worldmaking::Runway>& runways = made->runways;
    const worldmaking::RunwayTable& table = listed->runways;
    runways.insert(runways.end(), table.runways.begin(), table.runways.end());
    map->land.notes.insert(map->land.notes.end(), table.notes.begin(), table.notes.end());
    WorldMaker maker({request, map->streets, map->land, *bounds, runways, table.unusable, made->hasSea,
                      waterOf(map->land, isMadeUp, made->hasSea), made->places, ground->placeInScene,
                      made->climate, *std::move(cover)},
                     ground->heightM, std::move(*state), progress);
    if (!isMadeUp) tellOfMap(*map, mapNameOf(request), maker.report.json);
    if (isMadeUp) maker.report.json["madeUp"] = made->report;
    if (isMadeUp) maker.report.json["places"] = rowsOf(made->places);
    if (const auto done = maker.make(); !done) return done.error();
    tell(maker.report.json, request);
    return maker.report;
}

} // namespace worldtool
