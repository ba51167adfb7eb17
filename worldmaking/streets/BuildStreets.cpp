// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/BuildStreets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <osgRoads/core/query/GeoReference.h>

#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/StreetNetwork.h"
#include "worldmaking/streets/UntoldBridges.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::GeoReference;

constexpr double kShortestChainM = 4.0; ///< shorter ones make one crossing of two

osgRoads::core::NetworkHeader headerOf(const StreetMap& map)
{
    double south = 90.0, north = -90.0, west = 180.0, east = -180.0;
    for (const MapNode& node : map.nodes)
    {
        south = std::min(south, node.latitudeDeg), north = std::max(north, node.latitudeDeg);
        west = std::min(west, node.longitudeDeg), east = std::max(east, node.longitudeDeg);
    }
    osgRoads::core::NetworkHeader header;
    header.revMinor = 7;
    header.vendor = "osgTrainer worldtool";
    char text[160];
    std::snprintf(text, sizeof text,
                  "+proj=tmerc +lat_0=%.6f +lon_0=%.6f +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs",
                  0.5 * (south + north), 0.5 * (west + east));
    header.geoReference = text;
    return header;
}

/// Leaves out ways of which a node is not on the ground.
StreetMap onGround(const StreetMap& map, const GroundOnEarth& ground, StreetReport& report)
{
    std::vector<char> isOnGround;
    for (const MapNode& node : map.nodes)
        isOnGround.push_back(ground(node.latitudeDeg, node.longitudeDeg) ? 1 : 0);
    StreetMap kept = map;
    const auto leaves = [&](const MapWay& way)
    {
        return std::any_of(way.nodes.begin(), way.nodes.end(),
                           [&](std::uint32_t node) { return isOnGround[node] == 0; });
    };
    report.waysBeyondGround = static_cast<std::size_t>(std::erase_if(kept.ways, leaves));
    return kept;
}

foundation::Result<std::vector<glm::dvec2>> placesOf(const StreetMap& map, const GeoReference& reference)
{
    std::vector<glm::dvec2> places;
    for (const MapNode& node : map.nodes)
    {
        const auto place = reference.toInertial({node.latitudeDeg, node.longitudeDeg, 0.0});
        if (!place) return place.error();
        places.emplace_back(*place);
    }
    return places;
}

std::vector<CentreLine> linesOf(const StreetGraph& graph, const std::vector<glm::dvec2>& places)
{
    std::vector<CentreLine> lines;
    for (const StreetChain& chain : graph.chains)
    {
        std::vector<glm::dvec2> points;
        for (const std::uint32_t point : chain.points)
            points.push_back(places[point]);
        lines.emplace_back(points);
    }
    return lines;
}

} // namespace

foundation::Result<Streets> buildStreets(const StreetMap& map, const GroundOnEarth& ground,
                                         const std::string& mapName)
{
    Streets streets;
    StreetReport& report = streets.report;
    report.ways = map.ways.size();
    report.missingNodes = map.missingNodes;
    report.shortWays = map.shortWays;
    streets.network.header = headerOf(map);
    const StreetMap used = onGround(map, ground, report);
    if (used.ways.empty())
        return foundation::Error{mapName, "none of its streets lies on the elevation data",
                                 "give a map and elevation data of the same region"};
    const auto reference = GeoReference::create(streets.network.header, mapName);
    if (!reference) return reference.error();
    const auto places = placesOf(used, *reference);
    if (!places) return places.error();
    const StreetGraph graph = graphOf(used, *places, kShortestChainM);
    if (graph.chains.empty())
        return foundation::Error{mapName, "there is no street for cars in it",
                                 "name an OpenStreetMap extract of the region"};
    const std::vector<CentreLine> lines = linesOf(graph, *places);
    const std::vector<ChainCut> cuts = mouthsOf(graph, lines);
    const Overpasses overpasses = overpassesOf(graph, *places, lines);
    const auto height = [&](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto geodetic = reference->toGeodetic({plan, 0.0});
        if (!geodetic) return std::nullopt;
        return ground(geodetic->latitudeDeg, geodetic->longitudeDeg);
    };
    const StreetHeights heights = heightsOf(graph, lines, cuts, overpasses.found, height);
    report.closedWays = graph.closedWays;
    report.overpasses = overpasses.found.size();
    report.lostOverpasses = heights.lostOverpasses;
    report.untoldOverpasses = overpasses.untold;
    StreetNetwork network(used, graph, lines, cuts, heights);
    network.build(streets.network, report);
    report.untoldBridges = addUntoldBridges(streets.network);
    return streets;
}

} // namespace worldmaking
