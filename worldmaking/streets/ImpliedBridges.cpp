// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/ImpliedBridges.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadNetwork;
using osgRoads::core::RoadStructure;

constexpr double kLookStepM = 5.0;
constexpr double kMostBesideM = 6.0; ///< from the middle of a road to lower lanes that take its ground
constexpr double kWallM = 0.9;       ///< that a bed and the skirt of a road's surface hide
constexpr double kSlope = 0.5, kSlopeFromM = 3.6; ///< of the ground, from so far beside the lower lanes on
constexpr double kAbutmentM = 6.0;                ///< of a bridge, before and after what it spans
constexpr double kLeastImpliedBridgeM = 2.0;

struct Stretch
{
    double from = 0.0, to = 0.0;
};

/// Whether a lower road takes the ground from under a place.
bool isWithoutGround(const RoadNetwork& network, const osgRoads::core::RoadLocator& locator, int index,
                     double s)
{
    const Road& road = network.roads[static_cast<std::size_t>(index)];
    if (osgRoads::core::structureAt(road, s)) return false;
    const auto lanes = osgRoads::core::extentAt(road, s);
    const auto place = osgRoads::core::surfacePoint(road, s, 0.5 * (lanes.leftT + lanes.rightT));
    const auto isReason = [&](const osgRoads::core::RoadMatch& match)
    {
        const auto& [other, otherS, t, h] = match.position;
        const Road& lower = network.roads[static_cast<std::size_t>(other)];
        if (osgRoads::core::structureAt(lower, otherS)) return false;
        const double fallM = place.z - osgRoads::core::surfacePoint(lower, otherS, t).z;
        return fallM > kWallM + kSlope * std::max(0.0, match.distance - kSlopeFromM);
    };
    return locator.holdsOnOther(glm::dvec2(place), kMostBesideM, index, isReason);
}

/// The stretches of a road without ground.
std::vector<Stretch> stretchesOf(const RoadNetwork& network, const osgRoads::core::RoadLocator& locator,
                                 int index)
{
    const Road& road = network.roads[static_cast<std::size_t>(index)];
    std::vector<Stretch> stretches;
    for (const double s : osgRoads::core::evenStations(road.length, kLookStepM))
    {
        if (!isWithoutGround(network, locator, index, s)) continue;
        const bool isTurn = !road.junctionId.empty();
        const Stretch next{isTurn ? 0.0 : std::max(0.0, s - kAbutmentM),
                           isTurn ? road.length : std::min(road.length, s + kAbutmentM)};
        if (!stretches.empty() && next.from <= stretches.back().to)
            stretches.back().to = next.to;
        else
            stretches.push_back(next);
    }
    return stretches;
}

/// Leaves the structures that a road has as they are: stretches end where these begin.
void cutOff(const Road& road, std::vector<Stretch>& stretches)
{
    for (const RoadStructure& structure : road.structures)
        for (Stretch& stretch : stretches)
        {
            const double end = structure.s + structure.length;
            if (stretch.to <= structure.s || stretch.from >= end) continue;
            if (stretch.from < structure.s)
                stretch.to = structure.s;
            else
                stretch.from = std::min(end, stretch.to);
        }
    std::erase_if(stretches, [&](const Stretch& stretch)
                  { return stretch.to - stretch.from < std::min(kLeastImpliedBridgeM, 0.9 * road.length); });
}

} // namespace

std::size_t addImpliedBridges(RoadNetwork& network)
{
    std::vector<std::vector<Stretch>> found;
    const osgRoads::core::RoadLocator locator(network);
    for (std::size_t i = 0; i < network.roads.size(); ++i)
        found.push_back(stretchesOf(network, locator, static_cast<int>(i)));
    std::size_t count = 0;
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        Road& road = network.roads[i];
        cutOff(road, found[i]);
        for (const Stretch& stretch : found[i])
        {
            RoadStructure bridge;
            bridge.kind = osgRoads::core::StructureKind::bridge;
            bridge.type = "concrete";
            bridge.id = road.id + "-u" + std::to_string(count++);
            bridge.s = stretch.from;
            bridge.length = stretch.to - stretch.from;
            road.structures.push_back(std::move(bridge));
        }
        std::sort(road.structures.begin(), road.structures.end(),
                  [](const RoadStructure& a, const RoadStructure& b) { return a.s < b.s; });
    }
    return count;
}

} // namespace worldmaking
