// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/check/CrossingCheck.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

#include "scenery/structures/Footbridge.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/streets/Overpass.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::PlacedNetwork;
using osgRoads::core::Road;

constexpr double kCrossLookM = 4.0, kTunnelLookM = 5.0;
constexpr double kPortalRoomM = 25.0; ///< behind a portal, where a roof may stand out
constexpr double kMostRoofM = 0.5;    ///< above the ground
constexpr double kJoinM = 0.5, kMostRailStepM = 0.3;
constexpr double kEndBesideM = 3.0;     ///< from the end of rails to the lanes that they end at
constexpr double kRailUnderDeckM = 9.0; ///< below a road, where rails do not end
constexpr double kWalkersM = 2.5, kLeastWalkersM = 2.2;

/// A piece of a road or a railway between two places.
struct WayStretch
{
    int road = -1;
    std::size_t rail = 0;
    double s = 0.0, lengthM = 0.0;
    glm::dvec3 from{0.0}, to{0.0};
};

const osgRoads::core::RoadStructure* structureNear(const Road& road, double s)
{
    for (const double at : {s, s - 1.0, s + 1.0})
        if (const auto* structure = osgRoads::core::structureAt(road, at)) return structure;
    return nullptr;
}

bool isTube(const Road& road, double s)
{
    const auto* structure = structureNear(road, s);
    return structure && structure->kind == osgRoads::core::StructureKind::tunnel;
}

/// Whether both belong to one crossing of streets, where they lie in one plane.
bool haveJunction(const Road& a, const Road& b)
{
    const auto leadsTo = [](const Road& road, const std::string& junction)
    {
        const auto is = [&](const auto& link)
        { return link && link->isJunction && link->elementId == junction; };
        return is(road.predecessor) || is(road.successor);
    };
    if (!a.junctionId.empty() && (a.junctionId == b.junctionId || leadsTo(b, a.junctionId))) return true;
    return !b.junctionId.empty() && leadsTo(a, b.junctionId);
}

class CrossingLooker
{
public:
    CrossingLooker(const PlacedNetwork* roads, std::span<const RailLine> rails) : _roads(roads), _rails(rails)
    {
        if (roads) addRoads();
        for (std::size_t rail = 0; rail < rails.size(); ++rail)
            for (std::size_t i = 0; i + 1 < rails[rail].points.size(); ++i)
                add({-1, rail, 0.0, 0.0, rails[rail].points[i], rails[rail].points[i + 1]});
    }

    void lookAtCrossings()
    {
        for (std::size_t i = 0; i < _stretches.size(); ++i)
        {
            const WayStretch& stretch = _stretches[i];
            _grid.near(boxOf({glm::dvec2(stretch.from), glm::dvec2(stretch.to)}),
                       [&](std::size_t j)
                       {
                           const bool isRoad = _stretches[j].road >= 0;
                           if (stretch.road < 0 && !isRoad && j > i)
                               lookAtLines(stretch, _stretches[j]);
                           else if (stretch.road >= 0 && (!isRoad || j > i))
                               lookAt(stretch, _stretches[j]);
                       });
        }
    }

    void lookAtTunnels(const foundation::HeightInPlan& groundM)
    {
        const osgRoads::core::TunnelTube tube;
        for (int i = 0; _roads && i < static_cast<int>(_roads->network().roads.size()); ++i)
            for (const auto& structure : _roads->road(i).structures)
            {
                if (structure.kind != osgRoads::core::StructureKind::tunnel || !_roads->road(i).isUsable)
                    continue;
                const double roomM = std::min(kPortalRoomM, 0.5 * structure.length);
                CrossingFault worst{CrossingFlaw::tunnel, i};
                for (double s = structure.s + roomM; s <= structure.s + structure.length - roomM + 1e-6;
                     s += kTunnelLookM)
                {
                    const glm::dvec3 place = middleAt(i, std::min(s, _roads->road(i).length));
                    const auto ground = groundM(place);
                    if (!ground) continue;
                    const double roofM = place.z + tube.crownM + tube.liningM - *ground;
                    if (roofM > std::max(kMostRoofM, worst.foundM))
                        worst.foundM = roofM, worst.sM = s, worst.place = place;
                }
                if (worst.foundM > 0.0) faults.push_back(worst);
            }
    }

    void lookAtTubes(const foundation::HeightInPlan& groundM)
    {
        for (const RailLine& line : _rails)
        {
            if (!line.isTube) continue;
            CrossingFault worst{CrossingFlaw::tunnel};
            for (const glm::dvec3& place : line.points)
            {
                const auto awayM = [&](const glm::dvec3& end)
                { return glm::distance(glm::dvec2(place), glm::dvec2(end)); };
                if (std::min(awayM(line.points.front()), awayM(line.points.back())) < kPortalRoomM) continue;
                const auto ground = groundM(place);
                if (!ground) continue;
                const double roofM = place.z + kTunnelRoofM - 0.1 - *ground;
                if (roofM > std::max(kMostRoofM, worst.foundM)) worst.foundM = roofM, worst.place = place;
            }
            if (worst.foundM > 0.0) faults.push_back(worst);
        }
    }

    void lookAtEnds()
    {
        for (std::size_t rail = 0; rail < _rails.size(); ++rail)
            if (!_rails[rail].isFootbridge)
                for (const bool isEnd : {false, true})
                    if (!_rails[rail].points.empty())
                        lookAtEnd(rail, isEnd ? _rails[rail].points.back() : _rails[rail].points.front());
    }

    std::vector<CrossingFault> faults;

private:
    glm::dvec3 middleAt(int road, double s) const
    {
        const auto lanes = osgRoads::core::extentAt(_roads->road(road), s);
        return _roads->surfacePoint(road, s, 0.5 * (lanes.leftT + lanes.rightT));
    }

    void addRoads()
    {
        for (int i = 0; i < static_cast<int>(_roads->network().roads.size()); ++i)
        {
            const Road& road = _roads->road(i);
            if (!road.isUsable) continue;
            const auto stations = osgRoads::core::evenStations(road.length, kCrossLookM);
            for (std::size_t k = 0; k + 1 < stations.size(); ++k)
                add({i, 0, stations[k], stations[k + 1] - stations[k], middleAt(i, stations[k]),
                     middleAt(i, stations[k + 1])});
        }
    }

    void add(const WayStretch& stretch)
    {
        _grid.add(_stretches.size(), boxOf({glm::dvec2(stretch.from), glm::dvec2(stretch.to)}));
        _stretches.push_back(stretch);
    }

    void lookAt(const WayStretch& a, const WayStretch& b)
    {
        if (a.road == b.road || (b.road >= 0 && haveJunction(_roads->road(a.road), _roads->road(b.road))))
            return;
        const auto shares =
            crossingShares(glm::dvec2(a.from), glm::dvec2(a.to), glm::dvec2(b.from), glm::dvec2(b.to));
        if (!shares) return;
        const glm::dvec3 at = glm::mix(a.from, a.to, shares->x);
        const double otherM = std::lerp(b.from.z, b.to.z, shares->y), s = a.s + shares->x * a.lengthM;
        if (b.road >= 0)
            lookAtRoads(a, s, at, b, b.s + shares->y * b.lengthM, otherM);
        else
            lookAtLine(a, s, at, _rails[b.rail], otherM);
    }

    /// Railways and footbridges.
    void lookAtLines(const WayStretch& a, const WayStretch& b)
    {
        const RailLine &first = _rails[a.rail], &second = _rails[b.rail];
        if (a.rail == b.rail || first.isTube || second.isTube) return;
        const auto shares =
            crossingShares(glm::dvec2(a.from), glm::dvec2(a.to), glm::dvec2(b.from), glm::dvec2(b.to));
        if (!shares) return;
        const glm::dvec3 at = glm::mix(a.from, a.to, shares->x);
        const double otherM = std::lerp(b.from.z, b.to.z, shares->y);
        const bool isFirstAbove = at.z >= otherM;
        const RailLine &upper = isFirstAbove ? first : second, &lower = isFirstAbove ? second : first;
        const double apartM = std::fabs(at.z - otherM), topM = lower.isFootbridge ? 0.0 : kRailTopM;
        if (apartM <= topM + kSameLevelM) return; // they meet, or cross on one level
        CrossingFault fault{CrossingFlaw::lines};
        fault.isUpperFootbridge = upper.isFootbridge, fault.isLowerFootbridge = lower.isFootbridge;
        fault.foundM = apartM - topM - (upper.isFootbridge ? scenery::kFootDeckM : kTrackDeckM);
        if (lower.isFootbridge && fault.foundM >= kLeastWalkersM) return;
        if (lower.isFootbridge) fault.wantedM = kWalkersM;
        note(fault, {glm::dvec2(at), std::max(at.z, otherM)});
    }

    void lookAtRoads(const WayStretch& a, double s, const glm::dvec3& at, const WayStretch& b, double otherS,
                     double otherM)
    {
        const bool isAbove = at.z >= otherM;
        const double apartM = std::fabs(at.z - otherM);
        if (apartM <= kSameLevelM) return;
        const WayStretch& lower = isAbove ? b : a;
        CrossingFault fault{CrossingFlaw::roads, isAbove ? a.road : b.road, lower.road, isAbove ? s : otherS};
        fault.foundM = apartM - deckAbove(lower.road, isAbove ? otherS : s, kRoadDeckM);
        note(fault, {glm::dvec2(at), std::max(at.z, otherM)});
    }

    void lookAtLine(const WayStretch& a, double s, const glm::dvec3& at, const RailLine& line, double otherM)
    {
        if (line.isFootbridge)
            lookAtFootbridge(a, s, at, otherM);
        else if (!line.isTube) // over a tube is ground
            lookAtRails(a, s, at, otherM);
    }

    void lookAtFootbridge(const WayStretch& a, double s, const glm::dvec3& at, double deckM)
    {
        const double aboveM = at.z - deckM;
        if (std::fabs(aboveM) <= kSameLevelM || isTube(_roads->road(a.road), s)) return;
        CrossingFault fault{CrossingFlaw::footbridge, a.road, -1, s};
        fault.isRoadAbove = aboveM > 0.0;
        fault.foundM = fault.isRoadAbove ? aboveM - kRoadDeckM : -aboveM - scenery::kFootDeckM;
        if (fault.isRoadAbove && fault.foundM >= kLeastWalkersM) return;
        note(fault, at);
    }

    void lookAtRails(const WayStretch& a, double s, const glm::dvec3& at, double formationM)
    {
        const double aboveM = at.z - formationM;
        if (std::fabs(aboveM - kRailTopM) <= kSameLevelM) return;
        CrossingFault fault{CrossingFlaw::rails, a.road, -1, s};
        fault.isRoadAbove = aboveM > kRailTopM;
        fault.foundM =
            fault.isRoadAbove ? aboveM - kRailTopM - kRoadDeckM : -aboveM - deckAbove(a.road, s, kTrackDeckM);
        note(fault, at);
    }

    /// What lies between the room above a road and what passes over it: a deck, or the ground over a tube.
    double deckAbove(int road, double s, double deckM) const
    {
        const osgRoads::core::TunnelTube tube;
        return isTube(_roads->road(road), s) ? tube.crownM + tube.liningM - kLeastClearM : deckM;
    }

    void note(CrossingFault fault, const glm::dvec3& place)
    {
        if (fault.foundM >= kLeastClearM) return;
        if (fault.wantedM == 0.0) fault.wantedM = kClearM;
        fault.place = place;
        for (const CrossingFault& known : faults) // two stretches meet at the crossing
            if (known.flaw == fault.flaw && known.road == fault.road && known.other == fault.other &&
                glm::distance(known.place, place) < 2.0 * kCrossLookM)
                return;
        faults.push_back(fault);
    }

    void lookAtEnd(std::size_t rail, const glm::dvec3& end)
    {
        double leastStepM = 1e9;
        const glm::dvec2 plan(end);
        const auto look = [&](std::size_t i)
        {
            const WayStretch& stretch = _stretches[i];
            if (stretch.road >= 0 || stretch.rail == rail) return;
            for (const glm::dvec3& place : {stretch.from, stretch.to})
                if (glm::distance(glm::dvec2(place), plan) < kJoinM)
                    leastStepM = std::min(leastStepM, std::fabs(place.z - end.z));
        };
        _grid.near({plan - kJoinM, plan + kJoinM}, look);
        if (leastStepM <= kMostRailStepM) return;
        CrossingFault fault{CrossingFlaw::railEnd};
        fault.place = end;
        if (leastStepM < 1e8)
        {
            fault.foundM = leastStepM;
            faults.push_back(fault);
            return;
        }
        if (!_roads) return;
        for (const auto& match : _roads->locator().within(glm::dvec2(_roads->toInertial(end)), kEndBesideM))
        {
            const auto& [road, s, t, h] = match.position;
            const double aboveM = _roads->surfacePoint(road, s, t).z - end.z;
            const bool isOn = structureNear(_roads->road(road), s) != nullptr;
            if (!isOn && std::fabs(aboveM - kRailTopM) <= kSameLevelM) continue; // a siding ends at a street
            if (!isOn && aboveM < kSameLevelM) continue;
            if (std::fabs(aboveM) > kRailUnderDeckM) continue;
            fault.road = road, fault.sM = s, fault.foundM = aboveM;
            faults.push_back(fault);
            return;
        }
    }

    const PlacedNetwork* _roads;
    std::span<const RailLine> _rails;
    std::vector<WayStretch> _stretches;
    PlanGrid _grid;
};

} // namespace

const char* wordOf(CrossingFlaw flaw)
{
    switch (flaw)
    {
    case CrossingFlaw::roads:
        return "roads";
    case CrossingFlaw::rails:
        return "rails";
    case CrossingFlaw::tunnel:
        return "tunnel";
    case CrossingFlaw::railEnd:
        return "railEnd";
    case CrossingFlaw::footbridge:
        return "footbridge";
    case CrossingFlaw::lines:
        break;
    }
    return "lines";
}

std::vector<CrossingFault> crossingFaults(const PlacedNetwork* roads, std::span<const RailLine> rails,
                                          const foundation::HeightInPlan& groundM)
{
    CrossingLooker looker(roads, rails);
    looker.lookAtCrossings();
    looker.lookAtTunnels(groundM);
    looker.lookAtTubes(groundM);
    looker.lookAtEnds();
    return std::move(looker.faults);
}

} // namespace worldmaking
