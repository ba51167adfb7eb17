// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/check/WorldCheck.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <glm/glm.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/query/Stations.h>

#include "scenery/buildings/Outline.h"
#include "worldmaking/check/LevelCheck.h"
#include "worldmaking/land/Houses.h"
#include "worldmaking/plan/PlanGrid.h"

namespace worldmaking
{

namespace
{

using osgRoads::core::PlacedNetwork;

constexpr double kLaneStepM = 1.0, kEdgeStepM = 1.0, kRoadStepM = 5.0;
constexpr double kHeightSlackM = 0.02, kEndM = 0.5;

/// Finds outlines that hold a place.
class Outlines
{
public:
    void add(const PlanRings& rings, std::size_t number)
    {
        _grid.add(number, boxOf(rings.front()));
        _rings.resize(std::max(_rings.size(), number + 1));
        _rings[number] = &rings;
    }

    /// Calls `use(number)` for the outlines around a place.
    template<class Use>
    void around(const glm::dvec2& place, const Use& use) const
    {
        _grid.near({place, place},
                   [&](std::size_t i)
                   {
                       if (scenery::isWithin(*_rings[i], place)) use(i);
                   });
    }

    bool hold(const glm::dvec2& place) const
    {
        bool isHeld = false;
        around(place, [&](std::size_t) { isHeld = true; });
        return isHeld;
    }

private:
    std::vector<const PlanRings*> _rings;
    PlanGrid _grid;
};

bool isInTunnel(const osgRoads::core::Road& road, double s)
{
    const auto* const structure = osgRoads::core::structureAt(road, s);
    return structure && structure->kind == osgRoads::core::StructureKind::tunnel;
}

/// Whether a place lies on a bridge or in a tunnel, or so near its end that rounding decides.
bool isOnStructure(const osgRoads::core::Road& road, double s)
{
    const auto has = [&](double at) { return osgRoads::core::structureAt(road, at) != nullptr; };
    return has(s) || has(s - kEndM) || has(s + kEndM);
}

/// One look at a world.
class Checker
{
public:
    explicit Checker(const WorldThings& things) : _things(things)
    {
        for (std::size_t i = 0; i < things.houses.size(); ++i)
            if (things.houses[i].building.liftedM < kLeastClearM) // else lanes run below it
                _houses.add(things.houses[i].building.rings, i);
        for (std::size_t i = 0; i < things.waters.size(); ++i)
            _waters.add(things.waters[i], i);
        for (std::size_t i = 0; i < things.runways.size(); ++i)
            _runways.add(things.runways[i], i);
    }

    WorldFaults look()
    {
        _faults.objects = _things.houses.size() + _things.plants.size();
        lookAtHouses();
        lookAtPlants();
        if (_things.roads) lookAtRoads();
        _faults.onRoad += _housesOnRoads.size();
        return _faults;
    }

private:
    void lookAtHouses()
    {
        PlanGrid grid;
        for (std::size_t i = 0; i < _things.houses.size(); ++i)
        {
            const auto& house = _things.houses[i];
            const PlanRings& rings = house.building.rings;
            const glm::dvec2 middle = scenery::rectangleAround(rings.front()).middle;
            _faults.inWater += _waters.hold(middle) ? 1 : 0;
            _faults.onRunway += _runways.hold(middle) ? 1 : 0;
            if (auto fault = faultOf(house))
            {
                ++_faults.floating;
                fault->place = {middle, house.floorM};
                _faults.houseFaults.push_back(*fault);
            }
            const MapBox box = boxOf(rings.front());
            const double area = scenery::areaOf(rings);
            grid.near(box,
                      [&](std::size_t other)
                      {
                          // a part that begins above the ground lies over others
                          const auto& above = _things.houses[other].building;
                          if (house.building.liftedM > 0.0 || above.liftedM > 0.0) return;
                          const PlanRings& its = above.rings;
                          const double most =
                              std::max(kMostOverlapM2, kMostOverlap * std::min(area, scenery::areaOf(its)));
                          // The frames of placement and of the scene differ by less than a hundredth.
                          if (commonAreaOf(rings, its) > 1.05 * most) ++_faults.overlapping;
                      });
            grid.add(i, box);
        }
    }

    /// What is wrong between a house and its ground; nothing: it stands.
    std::optional<HouseFault> faultOf(const scenery::StandingBuilding& house) const
    {
        using Flaw = HouseFault::Flaw;
        double lowest = 1e300;
        for (const auto& ring : house.building.rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
            {
                const glm::dvec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
                const int steps = std::max(1, static_cast<int>(std::ceil(glm::length(b - a) / kEdgeStepM)));
                for (int k = 0; k < steps; ++k)
                {
                    const glm::dvec2 place = glm::mix(a, b, static_cast<double>(k) / steps);
                    const auto ground = _things.groundM(place);
                    if (!ground) return HouseFault{Flaw::beyond};
                    lowest = std::min(lowest, *ground);
                }
            }
        if (lowest < house.footM - kHeightSlackM) return HouseFault{Flaw::floats, {}, house.footM - lowest};
        const double eavesM = house.building.eavesM, shownM = house.floorM + eavesM - lowest;
        if (shownM < std::min(HouseFault::kLeastShownM, eavesM) - kHeightSlackM)
            return HouseFault{Flaw::sunk, {}, shownM};
        return std::nullopt;
    }

    void lookAtPlants()
    {
        for (const glm::dvec2& place : _things.plants)
        {
            _faults.inWater += _waters.hold(place) ? 1 : 0;
            _faults.onRunway += _runways.hold(place) ? 1 : 0;
            _faults.overlapping += _houses.hold(place) ? 1 : 0;
            const auto ground = _things.groundM(place);
            _faults.floating += ground ? 0 : 1;
            if (ground && _things.roads && isOnLanes(glm::dvec3(place, *ground))) ++_faults.onRoad;
        }
    }

    bool isOnLanes(const glm::dvec3& scene) const
    {
        const PlacedNetwork& roads = *_things.roads;
        const auto matches = roads.locator().within(glm::dvec2(roads.toInertial(scene)), 0.0);
        return std::any_of(matches.begin(), matches.end(),
                           [&](const osgRoads::core::RoadMatch& match)
                           { return !isInTunnel(roads.road(match.position.road), match.position.s); });
    }

    void lookAtRoads()
    {
        const PlacedNetwork& roads = *_things.roads;
        for (int i = 0; i < static_cast<int>(roads.network().roads.size()); ++i)
        {
            const auto& road = roads.road(i);
            if (!road.isUsable) continue;
            if (road.junctionId.empty()) _faults.roadsKm += 1e-3 * road.length;
            lookAtLanes(i);
            lookAtBed(i);
        }
    }

    /// The houses that a road's lanes run through.
    void lookAtLanes(int index)
    {
        const auto& road = _things.roads->road(index);
        for (const double s : osgRoads::core::evenStations(road.length, kLaneStepM))
        {
            _faults.maxGradePercent =
                std::max(_faults.maxGradePercent, 100.0 * std::abs(road.elevation.slope(s)));
            if (isInTunnel(road, s)) continue;
            const auto lanes = osgRoads::core::extentAt(road, s);
            for (const double t : {lanes.rightT, 0.5 * (lanes.rightT + lanes.leftT), lanes.leftT})
                _houses.around(glm::dvec2(_things.roads->surfacePoint(index, s, t)),
                               [&](std::size_t house) { _housesOnRoads.insert(house); });
        }
    }

    /// Whether the ground carries a road.
    void lookAtBed(int index)
    {
        const auto& road = _things.roads->road(index);
        RoadFault floating{false, index}, sunk{true, index};
        for (const double s : osgRoads::core::evenStations(road.length, kRoadStepM))
        {
            if (isOnStructure(road, s)) continue;
            const auto lanes = osgRoads::core::extentAt(road, s);
            const glm::dvec3 place =
                _things.roads->surfacePoint(index, s, 0.5 * (lanes.rightT + lanes.leftT));
            const auto ground = _things.groundM(place);
            const double gapM = ground ? place.z - *ground : 1e9;
            if (gapM > std::max(kMostGapM, floating.byM))
                floating.sM = s, floating.byM = gapM, floating.place = place;
            if (-gapM > std::max(kMostCoverM, sunk.byM)) sunk.sM = s, sunk.byM = -gapM, sunk.place = place;
        }
        _faults.floatingRoads += noted(floating) ? 1 : 0;
        _faults.sunkRoads += noted(sunk) ? 1 : 0;
    }

    /// Notes a fault, if it is one, with the road beside it.
    bool noted(RoadFault fault)
    {
        if (fault.byM <= 0.0) return false;
        const PlacedNetwork& roads = *_things.roads;
        for (const auto& match :
             roads.locator().within(glm::dvec2(roads.toInertial(fault.place)), RoadFault::kReasonM))
        {
            if (match.position.road == fault.road) continue;
            const double higherM =
                roads.surfacePoint(match.position.road, match.position.s, match.position.t).z - fault.place.z;
            if (std::abs(higherM) < RoadFault::kReasonHeightM) continue;
            fault.other = match.position.road;
            fault.otherM = match.distance;
            fault.otherHigherM = higherM;
            break;
        }
        _faults.roadFaults.push_back(fault);
        return true;
    }

    const WorldThings& _things;
    Outlines _houses, _waters, _runways;
    std::set<std::size_t> _housesOnRoads;
    WorldFaults _faults;
};

} // namespace

WorldFaults checkWorld(const WorldThings& things)
{
    WorldFaults faults = Checker(things).look();
    faults.crossingFaults = crossingFaults(things.roads, things.rails, things.groundM);
    for (const CrossingFault& fault : faults.crossingFaults)
        ++(fault.flaw == CrossingFlaw::tunnel    ? faults.bareTunnels
           : fault.flaw == CrossingFlaw::railEnd ? faults.brokenRails
                                                 : faults.closeCrossings);
    if (things.roads) faults.junctionFaults = junctionFaults(*things.roads);
    for (const JunctionFault& fault : faults.junctionFaults)
        ++(fault.flaw == JunctionFlaw::step ? faults.steppedJunctions : faults.steepJunctions);
    if (!things.elevationM) return faults;
    for (const PlanRings& paving : things.runways)
    {
        const auto& corner = paving.front(); // two at one end, then two at the other
        faults.unevenRunways +=
            !isEvenRunway(runwayFigures(0.5 * (corner[0] + corner[3]), 0.5 * (corner[1] + corner[2]),
                                        glm::distance(corner[0], corner[3]), things.elevationM));
    }
    for (const PlanRings& water : things.waters)
    {
        const LevelFigures figures = waterFigures(water, things.courses, things.elevationM);
        if (isEvenWater(figures)) continue;
        const MapBox box = boxOf(water.front());
        faults.waterFaults.push_back({0.5 * (box.low + box.high), scenery::areaOf(water), figures});
    }
    faults.unevenWaters = faults.waterFaults.size();
    return faults;
}

} // namespace worldmaking
