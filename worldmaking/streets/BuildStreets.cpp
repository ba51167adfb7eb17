// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/BuildStreets.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <osgRoads/core/query/GeoReference.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "worldmaking/map/MapPlane.h"
#include "worldmaking/streets/CoverCrossings.h"
#include "worldmaking/streets/CrossedWays.h"
#include "worldmaking/streets/CrossingNotes.h"
#include "worldmaking/streets/FootLevels.h"
#include "worldmaking/streets/ImpliedBridges.h"
#include "worldmaking/streets/OpenTunnels.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/StreetNetwork.h"
#include "worldmaking/streets/Tracks.h"

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
StreetMap onGround(const StreetMap& map, const foundation::HeightOnEarth& ground, StreetReport& report)
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

/// Streets, then railways. Frame: the plan.
struct AllWays
{
    StreetGraph graph;
    std::vector<glm::dvec2> places; ///< of nodes
    std::vector<CentreLine> lines;
};

foundation::Result<AllWays> allWays(const StreetMap& streets, const StreetGraph& graph, const LandMap& land,
                                    const GeoReference& reference, const foundation::HeightOnEarth& ground,
                                    const foundation::HeightInPlan& height)
{
    AllWays ways;
    const StreetMap map = tracksOf(land, streets.nodes, ground);
    auto places = placesOf(map, reference);
    if (!places) return places.error();
    ways.places = std::move(*places);
    StreetGraph tracks = graphOf(map, ways.places, kShortestChainM, trackTraitsOf);
    openShortTunnels(tracks, ways.places, height);
    ways.graph = joined(graph, tracks);
    ways.lines = linesOf(ways.graph, ways.places);
    return ways;
}

/// The surface of a network's lanes.
class LaneSurface
{
public:
    explicit LaneSurface(const osgRoads::core::RoadNetwork& network) : _network(network), _locator(network) {}

    std::optional<double> heightAt(const glm::dvec2& place, StreetPlace on, double nearM) const
    {
        constexpr double kOtherLevelM = 3.5;
        std::optional<double> found;
        for (const auto& match : _locator.within(place, 0.01))
        {
            const auto& [index, s, t, h] = match.position;
            const auto& road = _network.roads[static_cast<std::size_t>(index)];
            if (placeOn(road, s) != on) continue;
            const double heightM = osgRoads::core::surfacePoint(road, s, t).z;
            if (std::fabs(heightM - nearM) < (found ? std::fabs(*found - nearM) : kOtherLevelM))
                found = heightM;
        }
        return found;
    }

private:
    static StreetPlace placeOn(const osgRoads::core::Road& road, double s)
    {
        const auto* structure = osgRoads::core::structureAt(road, s);
        if (!structure) return StreetPlace::ground;
        return structure->kind == osgRoads::core::StructureKind::bridge ? StreetPlace::bridge
                                                                        : StreetPlace::tunnel;
    }

    const osgRoads::core::RoadNetwork& _network;
    osgRoads::core::RoadLocator _locator;
};

Crossings crossingsOf(const AllWays& ways, std::size_t tracks, const LandMap& land, const MapPlane& plane)
{
    Crossings crossings;
    crossings.tracks = tracks;
    Overpasses passes = overpassesOf(ways.graph, ways.places, ways.lines);
    crossings.overpasses = std::move(passes.found);
    crossings.leftOpen = std::move(passes.leftOpen);
    crossings.levels = levelPlaces(ways.graph, crossings.tracks, ways.lines);
    for (const Overpass& pass : crossings.leftOpen) // a street and a railway: at one level
        if (pass.upper < crossings.tracks && pass.lower >= crossings.tracks)
            crossings.levels.push_back({pass.upper, pass.lower, pass.upperM, pass.lowerM});
    crossings.crossed = crossedPlaces(ways.graph, ways.places, ways.lines, land, plane);
    crossings.footLevels = footLevels(ways.graph, ways.places, ways.lines, land, plane);
    return crossings;
}

/// Writes what crosses what, and what became of it, into the report.
void countCrossings(const AllWays& ways, const Crossings& crossings, const StreetHeights& heights,
                    StreetReport& report)
{
    report.overpasses = crossings.overpasses.size();
    report.lostOverpasses = heights.lost.size();
    report.overpassesLeftOpen = crossings.leftOpen.size();
    report.tracks = ways.graph.chains.size() - crossings.tracks;
    report.levelCrossings = crossings.levels.size();
    report.bareTunnels = heights.bareTunnels.size();
}

std::string degreesText(const MapPlane& plane, const glm::dvec2& plan)
{
    const auto degrees = plane.toDegrees(plan);
    if (!degrees) return "a place off the map";
    char text[64];
    std::snprintf(text, sizeof text, "%.5f, %.5f", degrees->y, degrees->x);
    return text;
}

/// Streets and railways with what is found of them.
struct FittedWays
{
    AllWays ways;
    std::vector<ChainCut> cuts;
    Crossings crossings;
    StreetHeights heights;
};

/// What heights are fitted to.
struct WaySources
{
    const StreetMap& map;
    const LandMap& land;
    const std::vector<glm::dvec2>& places; ///< of the map's nodes
    const GeoReference& reference;
    const MapPlane& plane;
    const foundation::HeightOnEarth& ground;
    const foundation::HeightInPlan& height;
};

foundation::Result<FittedWays> fittedWays(const WaySources& from, const StreetGraph& graph)
{
    auto ways = allWays(from.map, graph, from.land, from.reference, from.ground, from.height);
    if (!ways) return ways.error();
    FittedWays fitted;
    fitted.ways = std::move(*ways);
    fitted.cuts = mouthsOf(graph, linesOf(graph, from.places));
    fitted.cuts.resize(fitted.ways.graph.chains.size());
    fitted.crossings = crossingsOf(fitted.ways, graph.chains.size(), from.land, from.plane);
    fitted.heights =
        heightsOf(fitted.ways.graph, fitted.ways.lines, fitted.cuts, fitted.crossings, from.height);
    return fitted;
}

/// Fits the heights of all ways; again, where short tunnels without a hill have no room for ramps.
/// `opened`: so many of them.
foundation::Result<FittedWays> fittedWithOpened(const WaySources& from, StreetGraph& graph,
                                                std::size_t& opened)
{
    constexpr int kMostRounds = 3; // what is opened gives others room, or takes it
    auto fitted = fittedWays(from, graph);
    for (int round = 0; fitted && round < kMostRounds; ++round)
    {
        const std::size_t more = openBareTunnels(
            graph, {fitted->ways.lines, fitted->cuts, fitted->crossings, fitted->heights}, from.height);
        if (more == 0) break;
        opened += more;
        fitted = fittedWays(from, graph);
    }
    return fitted;
}

} // namespace

foundation::Result<Streets> buildStreets(const StreetMap& map, const foundation::HeightOnEarth& ground,
                                         const std::string& mapName, const LandMap* land)
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
    StreetGraph graph = graphOf(used, *places, kShortestChainM);
    if (graph.chains.empty())
        return foundation::Error{mapName, "there is no street for cars in it",
                                 "name an OpenStreetMap extract of the region"};
    const auto height = [&](const glm::dvec2& plan) -> std::optional<double>
    {
        const auto geodetic = reference->toGeodetic({plan, 0.0});
        if (!geodetic) return std::nullopt;
        return ground(geodetic->latitudeDeg, geodetic->longitudeDeg);
    };
    const auto plane = MapPlane::create(streets.network.header, mapName);
    if (!plane) return plane.error();
    const LandMap noLand;
    const foundation::HeightInPlan groundHeight = height;
    std::size_t opened = 0;
    const auto fitted = fittedWithOpened(
        {used, land ? *land : noLand, *places, *reference, *plane, ground, groundHeight}, graph, opened);
    if (!fitted) return fitted.error();
    const auto& [ways, cuts, crossings, heights] = *fitted;
    report.closedWays = graph.closedWays;
    countCrossings(ways, crossings, heights, report);
    StreetNetwork network(used, graph, ways.lines, cuts, heights);
    network.build(streets.network, report);
    report.coveredCrossings = coverCrossings(streets.network, ways.graph, cuts, crossings, heights);
    report.impliedBridges = addImpliedBridges(streets.network);
    const auto spans = trackSpans(ways.graph, cuts, crossings, heights);
    const LaneSurface surface(streets.network);
    const StreetSurface streetAt = [&](const glm::dvec2& place, StreetPlace on, double nearM)
    { return surface.heightAt(place, on, nearM); };
    streets.tracks = tracksWithHeights(
        {ways.graph, crossings.tracks, ways.lines, ways.places, heights, spans, groundHeight, streetAt});
    Footbridges footbridges = footbridgesOf({ways.graph, ways.places, ways.lines, cuts, heights,
                                             land ? *land : noLand, *plane, groundHeight, streetAt});
    streets.footbridges = std::move(footbridges.made);
    const auto placeText = [&](const glm::dvec2& plan) { return degreesText(*plane, plan); };
    report.notes = crossingNotes({ways.graph, ways.lines, cuts, crossings, heights, placeText,
                                  [&](std::size_t shape) { return land->shapes[shape].id; }});
    report.notes.insert(report.notes.end(), footbridges.notes.begin(), footbridges.notes.end());
    if (opened > 0)
        report.notes.push_back(
            std::to_string(opened) +
            " short tunnels of streets have neither a hill nor room for ramps: they are open");
    return streets;
}

} // namespace worldmaking
