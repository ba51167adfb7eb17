// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/SessionTraffic.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "simulation/scenario/DefaultVehicle.h"

namespace simulation
{
namespace
{

/// Somebody who drives `share` of what is allowed, `headwayS` behind others: around the 1 s of the
/// intelligent driver model (Treiber and Kesting, *Traffic Flow Dynamics*, 2013, table 11.2), so that a queue
/// flows off at green as the *Highway Capacity Manual* has it. The rest is chosen.
TrafficMix::Driver driver(double weight, const char* share, const char* headwayS)
{
    Controller controller;
    controller.name = "IntelligentDriver";
    controller.properties.values = {{"keepsRules", "true"},   {"limitShare", share},
                                    {"desiredTHW", headwayS}, {"desiredDistance", "2.0"},
                                    {"maxAcc", "1.4"},        {"comfortDec", "2.0"}};
    return {weight, controller};
}

TrafficKind kind(double weight, const char* category)
{
    TrafficKind made;
    made.weight = weight;
    made.object.object = defaultVehicle(category);
    return made;
}

} // namespace

std::optional<double> trafficDensity(std::string_view text)
{
    if (text == "none") return 0.0;
    if (text == "light") return SessionTraffic::kLightPerKm;
    if (text == "medium") return SessionTraffic::kMediumPerKm;
    if (text == "dense") return SessionTraffic::kDensePerKm;
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value >= 0.0 && value <= SessionTraffic::kMostPerKm ? std::optional(value) : std::nullopt;
}

void addTraffic(Scenario& scenario, const std::string& around, const SessionTraffic& traffic)
{
    constexpr double kBeginM = 40.0;       ///< nobody begins nearer than that
    constexpr double kRadiusPerKmM = 50.0; ///< a town has no more streets in 400 m around: 8 km
    if (!(traffic.perKm > 0.0)) return;
    TrafficSwarm swarm;
    swarm.central = around;
    swarm.semiMajorM = swarm.semiMinorM = traffic.radiusM;
    swarm.innerRadiusM = kBeginM;
    const double most = std::ceil(traffic.perKm * traffic.radiusM / kRadiusPerKmM);
    swarm.count = static_cast<int>(std::min<double>(most, SessionTraffic::kMostVehicles));
    swarm.perKm = traffic.perKm;
    swarm.mix.kinds = {kind(0.85, "car"), kind(0.15, "van")};
    swarm.mix.drivers = {driver(0.3, "0.85", "1.3"), driver(0.5, "0.95", "1.1"), driver(0.2, "1.0", "0.9")};
    TrafficAction action;
    action.name = "Traffic";
    action.content = std::move(swarm);
    scenario.storyboard.init.globals.push_back(GlobalAction(std::move(action)));
}

} // namespace simulation
