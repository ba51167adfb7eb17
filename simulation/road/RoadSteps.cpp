// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 10.3 (road linkage), 11.5 (lane linkage), 12 (junctions).
#include <cstdlib>

#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

using osgRoads::core::ContactPoint;
using osgRoads::core::Junction;
using osgRoads::core::JunctionConnection;
using osgRoads::core::Lane;
using osgRoads::core::Road;

bool hasLane(const Road& road, bool atStart, int lane)
{
    if (road.sections.empty()) return false;
    return (atStart ? road.sections.front() : road.sections.back()).lane(lane) != nullptr;
}

/// The lane of the next road that a lane is linked to; without a link the one that lies in the same place.
std::optional<int> linkedLane(const Road& road, bool atEnd, int lane, const Road& next, bool entersAtStart)
{
    if (lane == 0) return 0;
    const auto& section = atEnd ? road.sections.back() : road.sections.front();
    if (const Lane* const from = section.lane(lane))
    {
        const std::vector<int>& links = atEnd ? from->successors : from->predecessors;
        if (!links.empty()) return links.front();
    }
    const int same = atEnd == entersAtStart ? lane : -lane;
    if (hasLane(next, entersAtStart, same)) return same;
    return std::nullopt;
}

/// The lane of the connecting road that a lane leads to.
std::optional<int> connectedLane(const JunctionConnection& connection, int lane)
{
    if (lane == 0) return 0;
    if (connection.laneLinks.empty()) return lane;
    for (const JunctionConnection::LaneLink& link : connection.laneLinks)
        if (link.from == lane) return link.to;
    return std::nullopt;
}

} // namespace

std::vector<RoadStep> stepsFrom(const osgRoads::core::RoadNetwork& network, int road, bool atEnd, int lane)
{
    std::vector<RoadStep> steps;
    const Road& from = network.roads[static_cast<std::size_t>(road)];
    const auto& link = atEnd ? from.successor : from.predecessor;
    if (!link || link->index < 0 || from.sections.empty()) return steps;
    const auto add = [&](int next, bool entersAtStart, std::optional<int> nextLane)
    {
        if (next < 0 || !nextLane) return;
        const Road& to = network.roads[static_cast<std::size_t>(next)];
        if (to.isUsable && hasLane(to, entersAtStart, *nextLane))
            steps.push_back({next, entersAtStart, *nextLane});
    };
    if (!link->isJunction)
    {
        const bool entersAtStart = link->contactPoint == ContactPoint::start;
        const Road& next = network.roads[static_cast<std::size_t>(link->index)];
        if (!next.sections.empty())
            add(link->index, entersAtStart, linkedLane(from, atEnd, lane, next, entersAtStart));
        return steps;
    }
    const Junction& junction = network.junctions[static_cast<std::size_t>(link->index)];
    for (const JunctionConnection& connection : junction.connections)
        if (connection.incomingRoad == road)
            add(connection.connectingRoad, connection.contactPoint == ContactPoint::start,
                connectedLane(connection, lane));
    return steps;
}

} // namespace simulation
