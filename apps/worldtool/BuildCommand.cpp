// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>

#include <foundation/WholeFile.h>

#include <osgRoads/core/write/WriteNetwork.h>

#include "worldmaking/land/HouseFile.h"
#include "worldmaking/map/ReadLand.h"
#include "worldmaking/map/ReadOsm.h"
#include "worldmaking/streets/BuildStreets.h"
#include "worldtool/Commands.h"
#include "worldtool/EarthGround.h"

namespace worldtool
{

namespace
{

using nlohmann::ordered_json;
using worldmaking::HouseReport;
using worldmaking::MapBounds;
using worldmaking::StreetReport;

constexpr double kRoadSampleM = 3.0; ///< between samples of the ground beside roads

ordered_json rowOf(const StreetReport& report)
{
    return {{"ways", report.ways},
            {"closedWays", report.closedWays},
            {"waysBeyondGround", report.waysBeyondGround},
            {"shortWays", report.shortWays},
            {"missingNodes", report.missingNodes},
            {"streets", report.streets},
            {"crossings", report.crossings},
            {"turns", report.turns},
            {"bridges", report.bridges},
            {"tunnels", report.tunnels},
            {"overpasses", report.overpasses},
            {"lostOverpasses", report.lostOverpasses},
            {"untoldOverpasses", report.untoldOverpasses},
            {"sharpBends", report.sharpBends},
            {"roadsKm", report.lengthKm},
            {"maxGradePercent", report.steepestPercent},
            {"steepKm", report.steepKm}};
}

ordered_json rowOf(const HouseReport& report)
{
    return {{"read", report.read},
            {"standing", report.standing},
            {"towers", report.towers},
            {"cutBack", report.cutBack},
            {"onRoad", report.onRoad},
            {"overlapping", report.overlapping},
            {"inWater", report.inWater},
            {"underground", report.underground},
            {"beyondGround", report.beyondGround},
            {"unusable", report.unusable}};
}

/// The terrain's description. A path between the folders keeps a world usable when both are moved together.
std::string describe(const Request& request, bool hasHouses)
{
    std::ostringstream text;
    text << "# Made by worldtool build.\n";
    for (const auto& dem : request.dems)
    {
        std::error_code failed;
        const auto relative = std::filesystem::relative(dem, request.world, failed);
        text << "dem = " << (failed || relative.empty() ? std::filesystem::absolute(dem) : relative).string()
             << '\n';
    }
    text << "roads = roads.xodr\nroads_heights = file\nfinest_spacing = " << kRoadSampleM << '\n';
    if (hasHouses) text << "buildings = buildings.gpkg\n";
    return text.str();
}

foundation::Result<MapBounds> boundsOf(const Request& request)
{
    const auto& b = request.bounds;
    if (b.empty()) return MapBounds();
    if (b[0] < b[2] && b[1] < b[3]) return MapBounds{b[0], b[1], b[2], b[3]};
    return foundation::Error{"--bounds", "is no rectangle", "give WEST,SOUTH,EAST,NORTH in degrees"};
}

/// Leaves out streets of which no node lies within bounds.
void cutTo(const MapBounds& bounds, worldmaking::StreetMap& streets)
{
    std::erase_if(streets.ways,
                  [&](const worldmaking::MapWay& way)
                  {
                      return std::none_of(way.nodes.begin(), way.nodes.end(),
                                          [&](std::uint32_t node)
                                          {
                                              const auto& at = streets.nodes[node];
                                              return bounds.contains({at.longitudeDeg, at.latitudeDeg});
                                          });
                  });
}

bool isOsm(const std::filesystem::path& file)
{
    const std::string name = file.filename().string();
    return name.ends_with(".osm") || name.ends_with(".osm.gz") || name.ends_with(".pbf") ||
           name.ends_with(".osm.bz2");
}

/// A map: its streets with nodes and rules of turns, and everything as shapes.
struct WholeMap
{
    worldmaking::StreetMap streets;
    worldmaking::LandMap land;
};

foundation::Result<WholeMap> readMap(const std::filesystem::path& file, const MapBounds& bounds)
{
    WholeMap map;
    if (isOsm(file))
    {
        auto streets = worldmaking::readOsm(file);
        if (!streets) return streets.error();
        map.streets = std::move(*streets);
        cutTo(bounds, map.streets);
    }
    auto land = worldmaking::readLand(file, bounds);
    if (!land) return land.error();
    map.land = std::move(*land);
    if (!isOsm(file)) map.streets = worldmaking::streetsOf(map.land);
    return map;
}

void print(const ordered_json& rows)
{
    for (const auto& [part, row] : rows.items())
        for (const auto& [key, value] : row.items())
            std::cout << part << '.' << key << ' ' << value.dump() << '\n';
}

/// What is made of a map on a ground, and written.
class WorldMaker
{
public:
    WorldMaker(const Request& request, const WholeMap& map, const worldmaking::GroundOnEarth& ground)
        : _request(request), _map(map), _ground(ground)
    {
    }

    foundation::Outcome make()
    {
        const auto streets = worldmaking::buildStreets(_map.streets, _ground, _request.map.string());
        if (!streets) return streets.error();
        report.json["streets"] = rowOf(streets->report);
        if (auto written = osgRoads::core::writeNetwork(streets->network, _request.world / "roads.xodr");
            !written)
            return written;
        const auto plane = worldmaking::MapPlane::create(streets->network.header, _request.map.string());
        if (!plane) return plane.error();
        const worldmaking::RoadRoom room(streets->network);
        if (auto made = makeHouses(*plane, room); !made) return made;
        if (auto written =
                foundation::writeWholeFile(_request.world / "report.json", report.json.dump(2) + '\n');
            !written)
            return written;
        return foundation::writeWholeFile(_request.world / "world.roam", describe(_request, _hasHouses));
    }

    Report report;

private:
    foundation::Outcome makeHouses(const worldmaking::MapPlane& plane, const worldmaking::RoadRoom& room)
    {
        HouseReport counts;
        const auto hasGround = [&](const glm::dvec2& plan)
        {
            const auto place = plane.toDegrees(plan);
            return place && _ground(place->y, place->x);
        };
        const auto houses = worldmaking::housesOf(_map.land, plane, room, hasGround, counts);
        report.json["buildings"] = rowOf(counts);
        _hasHouses = !houses.empty();
        return _hasHouses ? worldmaking::writeHouses(houses, _request.world / "buildings.gpkg")
                          : foundation::success();
    }

    const Request& _request;
    const WholeMap& _map;
    const worldmaking::GroundOnEarth& _ground;
    bool _hasHouses = false;
};

} // namespace

foundation::Result<Report> build(const Request& request)
{
    std::error_code failed;
    std::filesystem::create_directories(request.world, failed);
    if (failed)
        return foundation::Error{request.world.string(), "cannot be made: " + failed.message(),
                                 "name a folder that can be written"};
    const auto bounds = boundsOf(request);
    if (!bounds) return bounds.error();
    const auto map = readMap(request.map, *bounds);
    if (!map) return map.error();
    const auto ground = loadGround(request.dems);
    if (!ground) return ground.error();
    WorldMaker maker(request, *map, *ground);
    if (const auto made = maker.make(); !made) return made.error();
    print(maker.report.json);
    return maker.report;
}

} // namespace worldtool
