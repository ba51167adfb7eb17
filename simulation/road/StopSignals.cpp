// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/StopSignals.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace simulation
{
namespace
{

using osgRoads::core::LaneValidity;
using osgRoads::core::Signal;

bool isStopSign(const Signal& signal)
{
    return signal.type == "206" ||
           (signal.country == "se" && (signal.type == "b" || signal.type == "B") && signal.subtype == "2");
}

bool holdsFor(char orientation, const std::vector<LaneValidity>& validities, int lane, bool isForward)
{
    if (orientation != '0' && (orientation == '+') != isForward) return false;
    if (validities.empty()) return true;
    return std::any_of(validities.begin(), validities.end(),
                       [&](const LaneValidity& lanes) {
                           return lane >= std::min(lanes.fromLane, lanes.toLane) &&
                                  lane <= std::max(lanes.fromLane, lanes.toLane);
                       });
}

const Signal* signalOf(const osgRoads::core::RoadNetwork& network, const std::string& id)
{
    for (const osgRoads::core::Road& road : network.roads)
        for (const Signal& signal : road.signals)
            if (signal.id == id) return &signal;
    return nullptr;
}

} // namespace

bool isTrafficLight(const Signal& signal)
{
    constexpr std::array<std::string_view, 5> kLights{"1000001", "1000009", "1000010", "1000011", "1000012"};
    return std::find(kLights.begin(), kLights.end(), signal.type) != kLights.end();
}

std::vector<RoadStop> stopsBetween(const osgRoads::core::RoadNetwork& network, int road, int lane,
                                   double fromM, double toM)
{
    const osgRoads::core::Road& under = network.roads[static_cast<std::size_t>(road)];
    const bool isForward = toM >= fromM;
    std::vector<RoadStop> stops;
    const auto add =
        [&](const Signal& signal, double sM, char orientation, const std::vector<LaneValidity>& validities)
    {
        if (!isStopSign(signal) && !isTrafficLight(signal)) return;
        if (sM < std::min(fromM, toM) || sM > std::max(fromM, toM)) return;
        if (!holdsFor(orientation, validities, lane, isForward)) return;
        stops.push_back({sM, isStopSign(signal) ? std::string() : signal.id});
    };
    for (const Signal& signal : under.signals)
        add(signal, signal.s, signal.orientation, signal.validities);
    for (const osgRoads::core::SignalReference& reference : under.signalReferences)
        if (const Signal* const signal = signalOf(network, reference.id))
            add(*signal, reference.s, reference.orientation, reference.validities);
    std::stable_sort(stops.begin(), stops.end(),
                     [&](const RoadStop& a, const RoadStop& b)
                     { return isForward ? a.sM < b.sM : a.sM > b.sM; });
    return stops;
}

bool hasStopSigns(const osgRoads::core::RoadNetwork& network)
{
    return std::any_of(network.roads.begin(), network.roads.end(),
                       [](const osgRoads::core::Road& road)
                       { return std::any_of(road.signals.begin(), road.signals.end(), isStopSign); });
}

bool isSwitchedOff(const std::string& state)
{
    return state == "off" || state == "off;off;off";
}

bool isAmber(const std::string& state)
{
    return state == "yellow" || state == "amber" || state == "caution" || state == "off;on;off";
}

bool letsPass(const std::string& state)
{
    if (state.find("green") != std::string::npos || state == "go" || state == "off") return true;
    const std::size_t last = state.rfind(';');
    return last != std::string::npos && state.substr(last + 1) == "on";
}

bool holdsBack(const std::map<std::string, std::string>& states, const std::string& signal)
{
    const auto found = states.find(signal);
    return found != states.end() && !letsPass(found->second);
}

} // namespace simulation
