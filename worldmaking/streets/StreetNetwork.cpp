// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetNetwork.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::ContactPoint;
using osgRoads::core::Junction;
using osgRoads::core::JunctionConnection;
using osgRoads::core::LaneType;
using osgRoads::core::Road;
using osgRoads::core::RoadKind;
using osgRoads::core::RoadLink;
using osgRoads::core::RoadNetwork;
using osgRoads::core::RoadStructure;
using osgRoads::core::StructureKind;

constexpr double kGradeStepM = 5.0;
constexpr double kKmhPerMps = 3.6;
constexpr double kLeastStructureM = 2.0;

RoadLink linkTo(const StreetArm& arm)
{
    RoadLink link;
    link.elementId = std::to_string(arm.chain);
    link.contactPoint = arm.isEnd ? ContactPoint::end : ContactPoint::start;
    return link;
}

} // namespace

std::string StreetNetwork::junctionId(int crossing) const
{
    return std::to_string(_graph.chains.size() + static_cast<std::size_t>(crossing));
}

double StreetNetwork::placeOf(std::size_t chain, std::size_t point, double lengthM) const
{
    return std::clamp(_lines[chain].pointsM()[point] - _cuts[chain].startM, 0.0, lengthM);
}

Road StreetNetwork::roadOf(std::size_t index, StreetReport& report) const
{
    const StreetChain& chain = _graph.chains[index];
    const CentreLine& line = _lines[index];
    const double fromM = _cuts[index].startM, toM = line.lengthM() - _cuts[index].endM;
    Road road;
    road.id = std::to_string(index);
    road.name = _graph.traitsAt(chain, 0).name;
    road.length = toM - fromM;
    road.referenceLine = line.part(fromM, toM);
    road.elevation = _heights.profiles[index].elevation;
    road.superelevationRad = _heights.profiles[index].superelevationRad;
    std::vector<LayoutPart> parts;
    for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
    {
        const StreetTraits& traits = _graph.traitsAt(chain, piece);
        if (piece > 0 && traits.hasSameLanes(_graph.traitsAt(chain, piece - 1))) continue;
        const double startM = placeOf(index, piece, road.length);
        if (!parts.empty() && startM - parts.back().startM < kLeastRoadM)
            parts.back().layout = layoutOf(traits);
        else if (parts.empty() || startM < road.length - kLeastRoadM)
            parts.push_back({startM, layoutOf(traits)});
    }
    parts.front().startM = 0.0;
    RoadLanes lanes = lanesOf(parts, road.length);
    road.sections = std::move(lanes.sections);
    road.laneOffset = std::move(lanes.offset);
    addKinds(index, road);
    addStructures(index, road, report);
    const auto linkOf = [&](int crossing)
    {
        RoadLink link;
        link.isJunction = true;
        link.elementId = junctionId(crossing);
        return link;
    };
    if (chain.startCrossing >= 0) road.predecessor = linkOf(chain.startCrossing);
    if (chain.endCrossing >= 0) road.successor = linkOf(chain.endCrossing);
    road.isUsable = true;
    measure(index, road, report);
    return road;
}

void StreetNetwork::addKinds(std::size_t index, Road& road) const
{
    const StreetChain& chain = _graph.chains[index];
    for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
    {
        const StreetTraits& traits = _graph.traitsAt(chain, piece);
        const RoadKind kind{
            placeOf(index, piece, road.length), traits.roadType, {}, traits.speedKmh / kKmhPerMps};
        const bool isSame = !road.kinds.empty() && road.kinds.back().type == kind.type &&
                            road.kinds.back().metresPerSecond == kind.metresPerSecond;
        if (isSame) continue;
        if (!road.kinds.empty() && kind.s <= road.kinds.back().s)
            road.kinds.back() = {road.kinds.back().s, kind.type, {}, kind.metresPerSecond};
        else if (kind.s < road.length)
            road.kinds.push_back(kind);
    }
}

void StreetNetwork::addStructures(std::size_t index, Road& road, StreetReport& report) const
{
    const StreetChain& chain = _graph.chains[index];
    for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
    {
        const StreetPlace place = _graph.traitsAt(chain, piece).place;
        if (place == StreetPlace::ground) continue;
        const double startM = placeOf(index, piece, road.length);
        const double endM = placeOf(index, piece + 1, road.length);
        const auto kind = place == StreetPlace::bridge ? StructureKind::bridge : StructureKind::tunnel;
        if (!road.structures.empty())
        {
            RoadStructure& last = road.structures.back();
            if (last.kind == kind && startM - (last.s + last.length) < 1e-6)
            {
                last.length = endM - last.s;
                continue;
            }
        }
        RoadStructure structure;
        structure.kind = kind;
        structure.type = kind == StructureKind::bridge ? "concrete" : "standard";
        structure.s = startM;
        structure.length = endM - startM;
        road.structures.push_back(std::move(structure));
    }
    std::erase_if(road.structures,
                  [](const RoadStructure& structure) { return structure.length < kLeastStructureM; });
    for (std::size_t i = 0; i < road.structures.size(); ++i)
    {
        RoadStructure& structure = road.structures[i];
        structure.id = road.id + "-" + std::to_string(i);
        ++(structure.kind == StructureKind::bridge ? report.bridges : report.tunnels);
    }
}

void StreetNetwork::measure(std::size_t index, const Road& road, StreetReport& report) const
{
    const StreetChain& chain = _graph.chains[index];
    report.lengthKm += road.length / 1000.0;
    const double halfM = layoutOf(_graph.traitsAt(chain, 0)).halfWidthM();
    if (_lines[index].leastRadiusM() < halfM) ++report.sharpBends;
    std::size_t piece = 0;
    for (double s = 0.5 * kGradeStepM; s < road.length; s += kGradeStepM)
    {
        while (piece + 1 < chain.pieces.size() && placeOf(index, piece + 1, road.length) <= s)
            ++piece;
        const double grade = std::fabs(road.elevation.slope(s));
        report.steepestPercent = std::max(report.steepestPercent, 100.0 * grade);
        if (grade > _graph.traitsAt(chain, piece).steepest + 0.005) report.steepKm += kGradeStepM / 1000.0;
    }
}

StreetNetwork::Arm StreetNetwork::armOf(const StreetArm& arm, const Road& road) const
{
    Arm result;
    result.arm = arm;
    const double s = arm.isEnd ? road.length : 0.0;
    const auto frame = osgRoads::core::frameAt(road, s);
    const auto& section = arm.isEnd ? road.sections.back() : road.sections.front();
    const auto addSide = [&](int sign, std::vector<Gate>& gates)
    {
        osgRoads::core::forLanesOutwards(
            road, section, sign, s,
            [&](const osgRoads::core::LaneSpan& span)
            {
                if (span.lane->type != LaneType::driving || span.width() < 0.1) return true;
                const double heading = frame.headingRad + (sign > 0 ? std::numbers::pi : 0.0);
                gates.push_back(
                    {span.lane->id, {glm::dvec2(frame.pointAt(span.innerT, 0.0)), heading, span.width()}});
                return true;
            });
    };
    addSide(-1, arm.isEnd ? result.in : result.out);
    addSide(1, arm.isEnd ? result.out : result.in);
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

void StreetNetwork::build(RoadNetwork& network, StreetReport& report) const
{
    for (std::size_t i = 0; i < _graph.chains.size(); ++i)
        network.roads.push_back(roadOf(i, report));
    for (std::size_t i = 0; i < _graph.crossings.size(); ++i)
        addJunction(i, network, report);
    report.streets = _graph.chains.size();
    report.crossings = _graph.crossings.size();
    network.index();
}

} // namespace worldmaking
