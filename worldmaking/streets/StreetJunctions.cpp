// SPDX-License-Identifier: Apache-2.0
// The junctions of a StreetNetwork.
#include <algorithm>
#include <numbers>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

#include "worldmaking/streets/StreetNetwork.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::ContactPoint;
using osgRoads::core::Junction;
using osgRoads::core::JunctionConnection;
using osgRoads::core::LaneType;
using osgRoads::core::Road;
using osgRoads::core::RoadLink;
using osgRoads::core::RoadNetwork;

/// A turn between two bridges crosses the same air, one between two tunnels the same hill.
void addStructure(Road& road, StreetPlace place)
{
    const bool isBridge = place == StreetPlace::bridge;
    osgRoads::core::RoadStructure structure;
    structure.id = road.id + "-0";
    structure.kind = isBridge ? osgRoads::core::StructureKind::bridge : osgRoads::core::StructureKind::tunnel;
    structure.type = isBridge ? "concrete" : "standard";
    structure.length = road.length;
    road.structures.push_back(std::move(structure));
}

bool isForBuses(const std::vector<osgRoads::core::Lane>& side)
{
    return std::none_of(side.begin(), side.end(),
                        [](const osgRoads::core::Lane& lane)
                        { return lane.type == LaneType::driving && lane.access.empty(); });
}

/// Whether cars of both directions have the same lanes.
bool isOfSharedLanes(const osgRoads::core::LaneSection& section)
{
    const auto hasOwn = [](const std::vector<osgRoads::core::Lane>& side)
    {
        return std::any_of(side.begin(), side.end(),
                           [](const osgRoads::core::Lane& lane) {
                               return lane.type == LaneType::driving &&
                                      lane.direction != osgRoads::core::LaneDirection::both;
                           });
    };
    return !hasOwn(section.left) && !hasOwn(section.right);
}

RoadLink linkTo(const StreetArm& arm)
{
    RoadLink link;
    link.elementId = std::to_string(arm.chain);
    link.contactPoint = arm.isEnd ? ContactPoint::end : ContactPoint::start;
    return link;
}

} // namespace

StreetNetwork::Arm StreetNetwork::armOf(const StreetArm& arm, const Road& road) const
{
    Arm result;
    result.arm = arm;
    const double s = arm.isEnd ? road.length : 0.0;
    const auto frame = osgRoads::core::frameAt(road, s);
    const auto& section = arm.isEnd ? road.sections.back() : road.sections.front();
    auto& forward = arm.isEnd ? result.in : result.out;
    auto& backward = arm.isEnd ? result.out : result.in;
    const bool isSingleTrack = isOfSharedLanes(section);
    const auto addSide = [&](int sign, std::vector<Gate>& gates)
    {
        const bool isAgainst = isForBuses(sign > 0 ? section.left : section.right);
        osgRoads::core::forLanesOutwards(
            road, section, sign, s,
            [&](const osgRoads::core::LaneSpan& span)
            {
                if (span.lane->type != LaneType::driving || span.width() < 0.1 || isAgainst) return true;
                const bool isShared = span.lane->direction == osgRoads::core::LaneDirection::both;
                if (isShared && !isSingleTrack) return true; // nobody goes through it
                const auto gateAt = [&](double leftT, double headingRad) {
                    return Gate{span.lane->id,
                                {glm::dvec2(frame.pointAt(leftT, 0.0)), headingRad, span.width()}};
                };
                gates.push_back(gateAt(span.innerT, frame.headingRad + (sign > 0 ? std::numbers::pi : 0.0)));
                if (isShared) backward.push_back(gateAt(span.outerT, frame.headingRad + std::numbers::pi));
                return true;
            });
    };
    addSide(-1, forward);
    addSide(1, backward);
    return result;
}

bool StreetNetwork::isAllowed(const Crossing& crossing, const StreetArm& from, const StreetArm& to) const
{
    const auto wayOf = [&](const StreetArm& arm)
    {
        const auto& pieces = _graph.chains[arm.chain].pieces;
        return (arm.isEnd ? pieces.back() : pieces.front()).way;
    };
    const std::int64_t fromWay = wayOf(from), toWay = wayOf(to);
    for (const TurnRule& rule : _map.turnRules)
    {
        const auto isHere = [&](std::uint32_t point) { return _map.nodes[point].id == rule.via; };
        if (rule.from != fromWay || std::none_of(crossing.points.begin(), crossing.points.end(), isHere))
            continue;
        if (rule.isOnly != (rule.to == toWay)) return false;
    }
    return true;
}

std::vector<char> StreetNetwork::allowedTurns(const Crossing& crossing) const
{
    std::vector<char> allowed;
    for (const StreetArm& from : crossing.arms)
        for (const StreetArm& to : crossing.arms)
            allowed.push_back(isAllowed(crossing, from, to) ? 1 : 0);
    return allowed;
}

StreetPlace StreetNetwork::placeAt(const StreetArm& arm) const
{
    const StreetChain& chain = _graph.chains[arm.chain];
    return _graph.traitsAt(chain, arm.isEnd ? chain.pieces.size() - 1 : 0).place;
}

void StreetNetwork::addJunction(std::size_t index, RoadNetwork& network, StreetReport& report) const
{
    const Crossing& crossing = _graph.crossings[index];
    std::vector<Arm> arms;
    std::vector<ArmLanes> lanes;
    for (const StreetArm& arm : crossing.arms)
    {
        const Road& road = network.roads[arm.chain];
        arms.push_back(armOf(arm, road));
        const double heading = road.referenceLine.at(arm.isEnd ? road.length : 0.0).headingRad;
        lanes.push_back({heading + (arm.isEnd ? std::numbers::pi : 0.0),
                         static_cast<int>(arms.back().in.size()), static_cast<int>(arms.back().out.size())});
    }
    Junction junction;
    junction.id = junctionId(static_cast<int>(index));
    for (const Turn& turn : turnsOf(lanes, allowedTurns(crossing)))
    {
        const Gate& from = arms[turn.fromArm].in[static_cast<std::size_t>(turn.fromLane)];
        const Gate& to = arms[turn.toArm].out[static_cast<std::size_t>(turn.toLane)];
        Road road = connectingRoad(from.gate, to.gate, _heights.planes[index]);
        road.id = std::to_string(network.roads.size() + _graph.crossings.size());
        if (const StreetPlace place = placeAt(arms[turn.fromArm].arm);
            place != StreetPlace::ground && place == placeAt(arms[turn.toArm].arm))
            addStructure(road, place);
        road.junctionId = junction.id;
        road.predecessor = linkTo(arms[turn.fromArm].arm);
        road.successor = linkTo(arms[turn.toArm].arm);
        road.sections.front().right.front().predecessors = {from.laneId};
        road.sections.front().right.front().successors = {to.laneId};
        JunctionConnection connection;
        connection.id = std::to_string(junction.connections.size());
        connection.incomingRoadId = std::to_string(arms[turn.fromArm].arm.chain);
        connection.connectingRoadId = road.id;
        connection.laneLinks.push_back({from.laneId, -1});
        junction.connections.push_back(std::move(connection));
        network.roads.push_back(std::move(road));
        ++report.turns;
    }
    network.junctions.push_back(std::move(junction));
}

} // namespace worldmaking
