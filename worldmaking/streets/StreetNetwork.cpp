// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetNetwork.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "worldmaking/streets/SignalPlan.h"
#include "worldmaking/streets/StreetSignals.h"
#include "worldmaking/streets/TurnArrows.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::Road;
using osgRoads::core::RoadKind;
using osgRoads::core::RoadLink;
using osgRoads::core::RoadNetwork;
using osgRoads::core::RoadStructure;

constexpr double kGradeStepM = 5.0;
constexpr double kKmhPerMps = 3.6;
constexpr double kLeastStructureM = 2.0;

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
    RoadLanes lanes = lanesOf(layoutParts(index, road.length), road.length);
    road.sections = std::move(lanes.sections);
    road.laneOffset = std::move(lanes.offset);
    addKinds(index, road);
    addStructures(index, road, report);
    addTurnArrows(_graph, chain, road);
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

std::vector<LayoutPart> StreetNetwork::layoutParts(std::size_t index, double lengthM) const
{
    const StreetChain& chain = _graph.chains[index];
    std::vector<LayoutPart> parts;
    for (std::size_t piece = 0; piece < chain.pieces.size(); ++piece)
    {
        const StreetTraits& traits = _graph.traitsAt(chain, piece);
        if (piece > 0 && traits.hasSameLanes(_graph.traitsAt(chain, piece - 1))) continue;
        const double startM = placeOf(index, piece, lengthM);
        if (!parts.empty() && startM - parts.back().startM < kLeastRoadM)
            parts.back().layout = layoutOf(traits);
        else if (parts.empty() || startM < lengthM - kLeastRoadM)
            parts.push_back({startM, layoutOf(traits)});
    }
    parts.front().startM = 0.0;
    return parts;
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
        const auto kind = place == StreetPlace::bridge ? osgRoads::core::StructureKind::bridge
                                                       : osgRoads::core::StructureKind::tunnel;
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
        structure.type = kind == osgRoads::core::StructureKind::bridge ? "concrete" : "standard";
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
        ++(structure.kind == osgRoads::core::StructureKind::bridge ? report.bridges : report.tunnels);
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

void StreetNetwork::build(RoadNetwork& network, StreetReport& report) const
{
    for (std::size_t i = 0; i < _graph.chains.size(); ++i)
        network.roads.push_back(roadOf(i, report));
    for (std::size_t i = 0; i < _graph.crossings.size(); ++i)
        addJunction(i, network, report);
    report.streets = _graph.chains.size();
    report.crossings = _graph.crossings.size();
    addSignals(signalPlanOf(_map, _graph, _lines, _cuts), network, report);
    network.index();
}

} // namespace worldmaking
