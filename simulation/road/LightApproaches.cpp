// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/LightApproaches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <tuple>

#include <osgRoads/core/query/LaneSpan.h>

#include "simulation/road/SpeedLimit.h"
#include "simulation/road/StopSignals.h"

namespace simulation
{
namespace
{

using osgRoads::core::Junction;
using osgRoads::core::JunctionConnection;
using osgRoads::core::JunctionType;
using osgRoads::core::Road;
using osgRoads::core::RoadLink;
using osgRoads::core::Signal;
using LitNetwork = osgRoads::core::RoadNetwork;

constexpr double kLightNearM = 80.0, kTownMps = 50.0 / 3.6;
constexpr double kOneCrossingM = 40.0; ///< lights between junctions that stand so near belong together

/// Where a road with a direction leads.
struct ApproachEnd
{
    int junction = -1, road = -1;
    bool isForward = true;
    double farM = 0.0;
};

const RoadLink* linkAhead(const Road& road, bool isForward)
{
    const auto& link = isForward ? road.successor : road.predecessor;
    return link && link->index >= 0 ? &*link : nullptr;
}

/// The junction that follows within kLightNearM; nothing: none does.
std::optional<ApproachEnd> junctionAhead(const LitNetwork& network, int road, bool isForward, double fromM)
{
    constexpr int kMostRoads = 10;
    const Road* here = &network.roads[static_cast<std::size_t>(road)];
    double farM = isForward ? here->length - fromM : fromM;
    for (int count = 0; count < kMostRoads && farM <= kLightNearM; ++count)
    {
        const RoadLink* const link = linkAhead(*here, isForward);
        if (!link) return std::nullopt;
        if (link->isJunction)
        {
            const Junction& junction = network.junctions[static_cast<std::size_t>(link->index)];
            if (junction.type != JunctionType::common) return std::nullopt;
            return ApproachEnd{link->index, road, isForward, farM};
        }
        road = link->index;
        isForward = link->contactPoint == osgRoads::core::ContactPoint::start;
        here = &network.roads[static_cast<std::size_t>(road)];
        farM += here->length;
    }
    return std::nullopt;
}

bool leadsTo(const Road& road, bool isForward, int junction)
{
    const RoadLink* const link = linkAhead(road, isForward);
    return link && link->isJunction && link->index == junction;
}

/// Collects the lights of a network by whom they hold for.
class LightFinder
{
public:
    explicit LightFinder(const RoadScene& roads) : _roads(roads), _network(roads.network()) {}

    std::vector<LightApproach> find()
    {
        std::map<std::string, const Signal*> byId;
        for (const Road& road : _network.roads)
            for (const Signal& signal : road.signals)
                byId.emplace(signal.id, &signal);
        findPlaces();
        for (std::size_t i = 0; i < _network.roads.size(); ++i)
        {
            const Road& road = _network.roads[i];
            if (!road.isUsable || road.sections.empty()) continue;
            for (const Signal& signal : road.signals)
                add(signal, static_cast<int>(i), signal.s, signal.orientation);
            for (const osgRoads::core::SignalReference& reference : road.signalReferences)
                if (const auto found = byId.find(reference.id); found != byId.end())
                    add(*found->second, static_cast<int>(i), reference.s, reference.orientation);
        }
        std::vector<LightApproach> approaches;
        for (auto& [key, approach] : _found)
        {
            if (approach.junction < 0) continue;
            for (std::size_t i = 0; i < approach.lanes.size() && approach.lanes.size() < kMostLanes; ++i)
                addLanesBehind(i, approach);
            approaches.push_back(std::move(approach));
        }
        std::stable_sort(approaches.begin(), approaches.end(),
                         [](const LightApproach& a, const LightApproach& b) { return a.place < b.place; });
        for (auto& approach : _between)
        {
            approach.place = static_cast<int>(_network.junctions.size() + approaches.size());
            approaches.push_back(std::move(approach));
        }
        return approaches;
    }

private:
    static constexpr std::size_t kMostLanes = 200; ///< of an approach, with those behind its junction

    /// Junctions that belong together, and lights between junctions, by the controllers of the network.
    void findPlaces()
    {
        for (std::size_t i = 0; i < _network.junctions.size(); ++i)
            _places.push_back(static_cast<int>(i));
        std::map<std::string, int> firstOf;
        for (std::size_t i = 0; i < _network.junctions.size(); ++i)
            for (const std::string& id : _network.junctions[i].controllerIds)
            {
                const auto [first, isNew] = firstOf.emplace(id, _places[i]);
                const int from = _places[i], to = first->second;
                if (from != to)
                    std::replace(_places.begin(), _places.end(), std::max(from, to), std::min(from, to));
            }
        std::map<std::string, std::pair<int, const Signal*>> lights;
        for (std::size_t i = 0; i < _network.roads.size(); ++i)
            for (const Signal& signal : _network.roads[i].signals)
                if (signal.isDynamic && isTrafficLight(signal))
                    lights.emplace(signal.id, std::pair(static_cast<int>(i), &signal));
        for (std::size_t i = 0; i < _network.controllers.size(); ++i)
        {
            if (firstOf.contains(_network.controllers[i].id)) continue;
            std::set<int> roads;
            bool isForward = false, isBackward = false;
            for (const auto& control : _network.controllers[i].controls)
                if (const auto found = lights.find(control.signalId); found != lights.end())
                {
                    roads.insert(found->second.first);
                    isForward |= found->second.second->orientation != '-';
                    isBackward |= found->second.second->orientation != '+';
                }
            if (roads.size() != 1 || !isForward || !isBackward) continue;
            for (const auto& control : _network.controllers[i].controls)
                _streetControllers.emplace(control.signalId, i);
        }
    }

    void add(const Signal& signal, int road, double atM, char orientation)
    {
        if (!signal.isDynamic || !isTrafficLight(signal)) return;
        const Road& under = _network.roads[static_cast<std::size_t>(road)];
        if (const auto street = _streetControllers.find(signal.id); street != _streetControllers.end())
        {
            addBetween(signal.id, road, atM, orientation != '-', static_cast<int>(street->second));
            return;
        }
        if (under.junction >= 0)
        {
            addInJunction(signal.id, road, atM, orientation);
            return;
        }
        bool isAtJunction = false;
        for (const bool isForward : {true, false})
        {
            if (orientation != '0' && (orientation == '+') != isForward) continue;
            const auto end = junctionAhead(_network, road, isForward, atM);
            if (!end) continue;
            isAtJunction = true;
            put(signal.id, *end);
        }
        if (!isAtJunction) addBetween(signal.id, road, atM, orientation != '-', -1);
    }

    void addInJunction(const std::string& light, int road, double atM, char orientation)
    {
        const int junction = _network.roads[static_cast<std::size_t>(road)].junction;
        for (const JunctionConnection& connection :
             _network.junctions[static_cast<std::size_t>(junction)].connections)
        {
            const bool isForward = connection.contactPoint == osgRoads::core::ContactPoint::start;
            if (connection.connectingRoad != road || connection.incomingRoad < 0) continue;
            if (orientation != '0' && (orientation == '+') != isForward) continue;
            const Road& incoming = _network.roads[static_cast<std::size_t>(connection.incomingRoad)];
            const double insideM =
                isForward ? atM : _network.roads[static_cast<std::size_t>(road)].length - atM;
            put(light, {junction, connection.incomingRoad, leadsTo(incoming, true, junction),
                        -std::max(insideM, 0.0)});
        }
    }

    void put(const std::string& light, const ApproachEnd& end)
    {
        const auto [at, isNew] = _found.try_emplace({end.junction, end.road, !end.isForward});
        LightApproach& approach = at->second;
        if (isNew) approach = madeOf(end);
        approach.lineM = std::max(approach.lineM, end.farM);
        if (std::find(approach.lights.begin(), approach.lights.end(), light) == approach.lights.end())
            approach.lights.push_back(light);
    }

    LightApproach madeOf(const ApproachEnd& end) const
    {
        LightApproach approach;
        approach.junction = end.junction;
        approach.place = _places[static_cast<std::size_t>(end.junction)];
        approach.road = end.road;
        approach.isForward = end.isForward;
        approach.lineM = end.farM;
        const Road& road = _network.roads[static_cast<std::size_t>(end.road)];
        const double endM = end.isForward ? road.length : 0.0;
        approach.headingRad =
            road.referenceLine.at(endM).headingRad + (end.isForward ? 0.0 : std::numbers::pi);
        approach.limitMps = limitAt(end.road, endM);
        for (const JunctionConnection& connection :
             _network.junctions[static_cast<std::size_t>(end.junction)].connections)
            if (leadsTo(road, end.isForward, end.junction) && connection.incomingRoad == end.road)
                addLanes(connection, 0.0, approach);
        return approach;
    }

    /// Who leaves the junction for another one of its place, where no light of theirs is, drives on.
    void addLanesBehind(std::size_t index, LightApproach& approach) const
    {
        const LightLane lane = approach.lanes[index];
        const Road& through = _network.roads[static_cast<std::size_t>(lane.lane.road)];
        const RoadLink* const link = linkAhead(through, lane.lane.isForward);
        if (!link || link->isJunction) return;
        const bool isForward = link->contactPoint == osgRoads::core::ContactPoint::start;
        const Road& between = _network.roads[static_cast<std::size_t>(link->index)];
        const RoadLink* const next = linkAhead(between, isForward);
        if (!next || !next->isJunction || next->index == through.junction ||
            _places[static_cast<std::size_t>(next->index)] != approach.place ||
            _found.contains({next->index, link->index, !isForward}))
            return;
        const double startM = lane.startM + through.length + between.length;
        for (const JunctionConnection& connection :
             _network.junctions[static_cast<std::size_t>(next->index)].connections)
            if (connection.incomingRoad == link->index) addLanes(connection, startM, approach);
    }

    void addLanes(const JunctionConnection& connection, double startM, LightApproach& approach) const
    {
        if (connection.connectingRoad < 0) return;
        const Road& through = _network.roads[static_cast<std::size_t>(connection.connectingRoad)];
        if (!through.isUsable || through.sections.empty()) return;
        const bool entersAtStart = connection.contactPoint == osgRoads::core::ContactPoint::start;
        const auto& section = entersAtStart ? through.sections.front() : through.sections.back();
        for (const auto side : {&osgRoads::core::LaneSection::left, &osgRoads::core::LaneSection::right})
            for (const osgRoads::core::Lane& lane : section.*side)
                if (osgRoads::core::isForCars(lane.type) &&
                    osgRoads::core::runsForward(through, lane) == entersAtStart)
                    addLane({{connection.connectingRoad, lane.id, entersAtStart}, startM}, approach);
    }

    static void addLane(const LightLane& lane, LightApproach& approach)
    {
        const bool isThere = std::any_of(approach.lanes.begin(), approach.lanes.end(),
                                         [&](const LightLane& other) { return other.lane == lane.lane; });
        if (!isThere) approach.lanes.push_back(lane);
    }

    double limitAt(int road, double atM) const
    {
        RoadPlace place;
        place.road = road;
        place.s = atM;
        return speedLimitAt(_roads, place).value_or(kTownMps);
    }

    /// Lights of one crossing for people on foot belong together. `controller`: their own; -1: none.
    void addBetween(const std::string& light, int road, double atM, bool isForward, int controller)
    {
        for (std::size_t i = 0; i < _between.size(); ++i)
            if (_between[i].road == road && _betweenControllers[i] == controller &&
                (controller >= 0 || std::abs(_between[i].atM - atM) < kOneCrossingM))
            {
                _between[i].lights.push_back(light);
                return;
            }
        LightApproach approach;
        approach.road = road;
        approach.isForward = isForward;
        approach.limitMps = limitAt(road, atM);
        approach.lights = {light};
        approach.atM = atM;
        _between.push_back(std::move(approach));
        _betweenControllers.push_back(controller);
    }

    const RoadScene& _roads;
    const LitNetwork& _network;
    std::map<std::tuple<int, int, bool>, LightApproach> _found; ///< by junction, road, backward
    std::vector<LightApproach> _between;
    std::vector<int> _betweenControllers;
    std::vector<int> _places;                              ///< of junctions: the first one that belongs to it
    std::map<std::string, std::size_t> _streetControllers; ///< of lights between junctions
};

} // namespace

std::vector<LightApproach> lightApproaches(const RoadScene& roads)
{
    return LightFinder(roads).find();
}

bool hasTrafficLights(const osgRoads::core::RoadNetwork& network)
{
    const auto shines = [](const Signal& signal) { return signal.isDynamic && isTrafficLight(signal); };
    return std::any_of(network.roads.begin(), network.roads.end(),
                       [&](const Road& road)
                       { return std::any_of(road.signals.begin(), road.signals.end(), shines); });
}

} // namespace simulation
