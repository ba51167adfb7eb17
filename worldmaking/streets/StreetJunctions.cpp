// SPDX-License-Identifier: Apache-2.0
// The junctions of a StreetNetwork.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

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

/// Gives a road its number, and its structures, which are called after it, too.
void setId(Road& road, std::size_t number)
{
    road.id = std::to_string(number);
    for (osgRoads::core::RoadStructure& structure : road.structures)
        structure.id = road.id + "-0";
}

/// Whether a lane is the outermost one for cars of its arm.
bool isBeside(const LaneGate& gate, const ArmSide& side)
{
    constexpr double kNearM = 0.1; // leaning lanes are narrower in the plan
    const glm::dvec2 right(std::sin(gate.headingRad), -std::cos(gate.headingRad));
    return glm::distance(gate.edge + gate.widthM * right, side.edge) < kNearM;
}

/// Returns the line of an arm's street from the middle of the crossing.
HalfLine lineOf(const ArmSides& sides, const glm::dvec2& middle)
{
    constexpr double kNearM = 1.0; // arms that begin in the middle
    const glm::dvec2 way = 0.5 * (sides.in.edge + sides.out.edge) - middle;
    const double heading = sides.out.headingRad;
    return {middle, glm::length(way) > kNearM ? way : glm::dvec2(std::cos(heading), std::sin(heading))};
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

/// Returns the arms with their lanes and sides, and where the lines of their streets meet.
StreetNetwork::ArmsOfCrossing StreetNetwork::armsOf(std::size_t index, const RoadNetwork& network) const
{
    ArmsOfCrossing crossing;
    crossing.index = index;
    for (const StreetArm& arm : _graph.crossings[index].arms)
    {
        crossing.arms.push_back(armOf(arm, network.roads[arm.chain]));
        crossing.arms.back().sides = sidesOf(network.roads[arm.chain], arm.isEnd);
        const CentreLine& line = _lines[arm.chain];
        crossing.middle += line.at(arm.isEnd ? line.lengthM() : 0.0).position;
    }
    crossing.middle /= static_cast<double>(std::max<std::size_t>(crossing.arms.size(), 1));
    return crossing;
}

/// Returns for each arm the next one to the left of it, seen from the middle.
std::vector<std::size_t> StreetNetwork::neighboursOf(const ArmsOfCrossing& crossing) const
{
    constexpr double kAwayM = 15.0; // tells even arms apart that begin in the middle
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < crossing.arms.size(); ++i)
    {
        const auto& [in, out] = crossing.arms[i].sides;
        const glm::dvec2 ahead(std::cos(out.headingRad), std::sin(out.headingRad));
        const glm::dvec2 way = 0.5 * (in.edge + out.edge) + kAwayM * ahead - crossing.middle;
        order.emplace_back(std::atan2(way.y, way.x), i);
    }
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> next(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        next[order[i].second] = order[(i + 1) % order.size()].second;
    return next;
}

Road StreetNetwork::roadAcross(const ArmsOfCrossing& crossing, std::size_t from, std::size_t to,
                               const LaneGate& start, const LaneGate& end) const
{
    const StreetArm &fromArm = crossing.arms[from].arm, &toArm = crossing.arms[to].arm;
    Road road = connectingRoad(start, end, _heights.planes[crossing.index]);
    if (const StreetPlace place = placeAt(fromArm); place != StreetPlace::ground && place == placeAt(toArm))
        addStructure(road, place);
    road.junctionId = junctionId(static_cast<int>(crossing.index));
    road.predecessor = linkTo(fromArm);
    road.successor = linkTo(toArm);
    return road;
}

void StreetNetwork::addTurns(const ArmsOfCrossing& crossing, const std::vector<std::size_t>& neighbours,
                             RoadNetwork& network, StreetReport& report) const
{
    const std::vector<Arm>& arms = crossing.arms;
    std::vector<ArmLanes> lanes;
    for (const Arm& arm : arms)
        lanes.push_back({network.roads[arm.arm.chain]
                                 .referenceLine.at(arm.arm.isEnd ? network.roads[arm.arm.chain].length : 0.0)
                                 .headingRad +
                             (arm.arm.isEnd ? std::numbers::pi : 0.0),
                         static_cast<int>(arm.in.size()), static_cast<int>(arm.out.size())});
    Junction junction;
    junction.id = junctionId(static_cast<int>(crossing.index));
    std::vector<char> hasEdge(arms.size(), 0);
    for (const Turn& turn : turnsOf(lanes, allowedTurns(_graph.crossings[crossing.index])))
    {
        const Arm &fromArm = arms[turn.fromArm], &toArm = arms[turn.toArm];
        const Gate& from = fromArm.in[static_cast<std::size_t>(turn.fromLane)];
        const Gate& to = toArm.out[static_cast<std::size_t>(turn.toLane)];
        Road road = roadAcross(crossing, turn.fromArm, turn.toArm, from.gate, to.gate);
        setId(road, network.roads.size() + _graph.crossings.size());
        road.sections.front().right.front().predecessors = {from.laneId};
        road.sections.front().right.front().successors = {to.laneId};
        if (neighbours[turn.fromArm] == turn.toArm && hasEdge[turn.fromArm] == 0 &&
            isBeside(from.gate, fromArm.sides.in) && isBeside(to.gate, toArm.sides.out))
        {
            addEdge(road, fromArm.sides.in, toArm.sides.out,
                    {lineOf(fromArm.sides, crossing.middle), lineOf(toArm.sides, crossing.middle)});
            hasEdge[turn.fromArm] = 1;
        }
        JunctionConnection connection;
        connection.id = std::to_string(junction.connections.size());
        connection.incomingRoadId = std::to_string(fromArm.arm.chain);
        connection.connectingRoadId = road.id;
        connection.laneLinks.push_back({from.laneId, -1});
        junction.connections.push_back(std::move(connection));
        network.roads.push_back(std::move(road));
        ++report.turns;
    }
    network.junctions.push_back(std::move(junction));
    addCorners(crossing, neighbours, hasEdge, network);
}

/// Corners that nobody turns at have an edge without lanes for cars.
void StreetNetwork::addCorners(const ArmsOfCrossing& crossing, const std::vector<std::size_t>& neighbours,
                               const std::vector<char>& hasEdge, RoadNetwork& network) const
{
    for (std::size_t from = 0; from < neighbours.size(); ++from)
    {
        const std::size_t to = neighbours[from];
        const ArmSide &start = crossing.arms[from].sides.in, &end = crossing.arms[to].sides.out;
        if (hasEdge[from] != 0 || from == to || !haveCorner(start, end)) continue;
        Road road = roadAcross(crossing, from, to, {start.edge, start.headingRad, 0.0},
                               {end.edge, end.headingRad, 0.0});
        setId(road, network.roads.size() + _graph.crossings.size());
        road.sections.front().right.clear();
        addEdge(road, start, end,
                {lineOf(crossing.arms[from].sides, crossing.middle),
                 lineOf(crossing.arms[to].sides, crossing.middle)});
        network.roads.push_back(std::move(road));
    }
}

void StreetNetwork::addJunction(std::size_t index, RoadNetwork& network, StreetReport& report) const
{
    const ArmsOfCrossing crossing = armsOf(index, network);
    addTurns(crossing, neighboursOf(crossing), network, report);
}

} // namespace worldmaking
