// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <sstream>
#include <string>
#include <system_error>

#include <foundation/WholeFile.h>

#include <osgRoads/core/write/WriteNetwork.h>

#include "worldmaking/map/ReadOsm.h"
#include "worldmaking/streets/BuildStreets.h"
#include "worldtool/Commands.h"
#include "worldtool/EarthGround.h"

namespace worldtool
{

namespace
{

using nlohmann::ordered_json;
using worldmaking::StreetReport;

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

/// The terrain's description. A path between the folders keeps a world usable when both are moved together.
std::string describe(const Request& request)
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
    text << "roads = roads.xodr\nroads_heights = file\n";
    return text.str();
}

foundation::Outcome write(const Request& request, const osgRoads::core::RoadNetwork& network,
                          const ordered_json& report)
{
    if (auto written = osgRoads::core::writeNetwork(network, request.world / "roads.xodr"); !written)
        return written;
    if (auto written = foundation::writeWholeFile(request.world / "report.json", report.dump(2) + '\n');
        !written)
        return written;
    return foundation::writeWholeFile(request.world / "world.roam", describe(request));
}

} // namespace

foundation::Result<Report> build(const Request& request)
{
    std::error_code failed;
    std::filesystem::create_directories(request.world, failed);
    if (failed)
        return foundation::Error{request.world.string(), "cannot be made: " + failed.message(),
                                 "name a folder that can be written"};
    const auto map = worldmaking::readOsm(request.map);
    if (!map) return map.error();
    const auto ground = loadGround(request.dems);
    if (!ground) return ground.error();
    const auto streets = worldmaking::buildStreets(*map, *ground, request.map.string());
    if (!streets) return streets.error();
    Report report;
    report.json["streets"] = rowOf(streets->report);
    if (const auto written = write(request, streets->network, report.json); !written) return written.error();
    for (const auto& [key, value] : report.json["streets"].items())
        std::cout << key << ' ' << value.dump() << '\n';
    return report;
}

} // namespace worldtool
