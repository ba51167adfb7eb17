// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/LightApproaches.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
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
            if (approach.junction >= 0) approaches.push_back(std::move(approach));
        for (auto& approach : _between)
            approaches.push_back(std::move(approach));
        return approaches;
    }

private:
    void add(const Signal& signal, int road, double atM, char orientation)
    {
        if (!signal.isDynamic || !isTrafficLight(signal)) return;
        const Road& under = _network.roads[static_cast<std::size_t>(road)];
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
        if (!isAtJunction) addBetween(signal.id, road, atM, orientation != '-');
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
                addLanes(connection, approach);
        return approach;
    }

    void addLanes(const JunctionConnection& connection, LightApproach& approach) const
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
                    approach.lanes.push_back({connection.connectingRoad, lane.id, entersAtStart});
    }

    double limitAt(int road, double atM) const
    {
        RoadPlace place;
        place.road = road;
        place.s = atM;
        return speedLimitAt(_roads, place).value_or(kTownMps);
    }

    /// Lights of one crossing for people on foot belong together.
    void addBetween(const std::string& light, int road, double atM, bool isForward)
    {
        for (std::size_t i = 0; i < _between.size(); ++i)
            if (_between[i].road == road && std::abs(_betweenM[i] - atM) < kOneCrossingM)
            {
                _between[i].lights.push_back(light);
                return;
            }
        LightApproach approach;
        approach.road = road;
        approach.isForward = isForward;
        approach.limitMps = limitAt(road, atM);
        approach.lights = {light};
        _between.push_back(std::move(approach));
        _betweenM.push_back(atM);
    }

    const RoadScene& _roads;
    const LitNetwork& _network;
    std::map<std::tuple<int, int, bool>, LightApproach> _found; ///< by junction, road, backward
    std::vector<LightApproach> _between;
    std::vector<double> _betweenM;
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
