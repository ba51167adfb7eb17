// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/FootLights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <osgRoads/core/query/LaneSpan.h>

namespace simulation
{
namespace
{

using FootNetwork = osgRoads::core::RoadNetwork;

double crossedM(const osgRoads::core::Road& road, double atM)
{
    double fromT = 1e9, toT = -1e9;
    const auto* section = osgRoads::core::sectionAt(road, atM);
    if (!section) return 0.0;
    for (const int sign : {-1, 1})
        osgRoads::core::forLanesOutwards(road, *section, sign, atM,
                                         [&](const osgRoads::core::LaneSpan& span)
                                         {
                                             if (!osgRoads::core::isForCars(span.lane->type)) return true;
                                             fromT = std::min({fromT, span.innerT, span.outerT});
                                             toT = std::max({toT, span.innerT, span.outerT});
                                             return true;
                                         });
    return std::max(toT - fromT, 0.0);
}

/// Finds the programme of lights for people on foot.
class FootPlaces
{
public:
    FootPlaces(const FootNetwork& network, const std::vector<LightApproach>& approaches)
        : _network(network), _approaches(approaches)
    {
        for (const LightApproach& approach : approaches)
            for (const std::string& light : approach.lights)
                _placeOfLight.emplace(light, approach.place);
        for (std::size_t i = 0; i < network.controllers.size(); ++i)
            for (const auto& control : network.controllers[i].controls)
                _controllerOf.emplace(control.signalId, i);
    }

    std::optional<int> placeOf(const std::string& light, int road, double atM) const
    {
        if (const auto found = _controllerOf.find(light); found != _controllerOf.end())
            for (const auto& control : _network.controllers[found->second].controls)
                if (const auto place = _placeOfLight.find(control.signalId); place != _placeOfLight.end())
                    return place->second;
        constexpr double kOneStreetM = 40.0, kAtEndM = 80.0;
        for (const LightApproach& approach : _approaches)
            if (approach.junction < 0 && approach.road == road && std::abs(approach.atM - atM) < kOneStreetM)
                return approach.place;
        const auto& under = _network.roads[static_cast<std::size_t>(road)];
        std::optional<std::pair<double, int>> nearest;
        for (const bool isEnd : {true, false})
        {
            const auto& link = isEnd ? under.successor : under.predecessor;
            if (!link || !link->isJunction) continue;
            const double farM = isEnd ? under.length - atM : atM;
            for (const LightApproach& approach : _approaches)
                if (approach.junction == link->index && farM < kAtEndM && (!nearest || farM < nearest->first))
                    nearest = {farM, approach.place};
        }
        return nearest ? std::optional(nearest->second) : std::nullopt;
    }

private:
    const FootNetwork& _network;
    const std::vector<LightApproach>& _approaches;
    std::map<std::string, int> _placeOfLight;
    std::map<std::string, std::size_t> _controllerOf;
};

} // namespace

std::vector<FootLight> footLights(const RoadScene& roads, const std::vector<LightApproach>& approaches)
{
    const FootNetwork& network = roads.network();
    const FootPlaces places(network, approaches);
    std::vector<FootLight> found;
    for (std::size_t i = 0; i < network.roads.size(); ++i)
    {
        const osgRoads::core::Road& road = network.roads[i];
        if (!road.isUsable || road.junction >= 0) continue;
        for (const osgRoads::core::Signal& signal : road.signals)
        {
            if (!signal.isDynamic || signal.type != "1000002") continue;
            if (const auto place = places.placeOf(signal.id, static_cast<int>(i), signal.s))
                found.push_back({signal.id, *place, static_cast<int>(i), crossedM(road, signal.s)});
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const FootLight& a, const FootLight& b) { return a.place < b.place; });
    return found;
}

bool goesWith(const FootLight& people, const LightApproach& approach, JunctionTable& table)
{
    constexpr double kStraightRad = 0.5;
    if (approach.road == people.road) return false;
    const auto& roads = table.roads().network().roads;
    return std::none_of(approach.lanes.begin(), approach.lanes.end(),
                        [&](const LightLane& through)
                        {
                            const auto& road = roads[static_cast<std::size_t>(through.lane.road)];
                            const auto& link = through.lane.isForward ? road.successor : road.predecessor;
                            return link && !link->isJunction && link->index == people.road &&
                                   std::abs(table.turnRad(through.lane)) < kStraightRad;
                        });
}

} // namespace simulation
