// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/traffic/TrafficPlan.h"

#include <set>

#include "simulation/parser/RandomDraw.h"
#include "simulation/scenario/DefaultVehicle.h"
#include "simulation/scenario/VisitActions.h"

namespace simulation
{
namespace
{

int countOf(const TrafficAction& action)
{
    if (const auto* swarm = std::get_if<TrafficSwarm>(&action.content)) return swarm->count;
    if (const auto* area = std::get_if<TrafficArea>(&action.content)) return area->count;
    return std::holds_alternative<TrafficSource>(action.content) ? TrafficPlan::kOfASource : 0;
}

const TrafficMix* mixOf(const TrafficAction& action)
{
    return std::visit(
        [](const auto& content) -> const TrafficMix*
        {
            if constexpr (requires { content.mix; })
                return &content.mix;
            else
                return nullptr;
        },
        action.content);
}

template<class Entry>
const Entry* drawn(const std::vector<Entry>& entries, RandomDraw& draw)
{
    std::vector<double> weights;
    double sum = 0.0;
    for (const Entry& entry : entries)
        sum += weights.emplace_back(entry.weight);
    return sum > 0.0 ? &entries[draw.index(weights)] : nullptr;
}

ScenarioObject vehicleOf(const TrafficMix& mix, RandomDraw& draw)
{
    ScenarioObject vehicle;
    vehicle.object = defaultVehicle("car");
    if (const TrafficKind* const kind = drawn(mix.kinds, draw)) vehicle = kind->object;
    if (!vehicle.controllers.empty()) return vehicle;
    const TrafficMix::Driver* const driver = drawn(mix.drivers, draw);
    vehicle.controllers = {driver ? driver->controller : Controller{{}, "IntelligentDriver", {}}};
    return vehicle;
}

} // namespace

TrafficPlan::TrafficPlan(Scenario& scenario, std::uint64_t seed)
{
    _first = static_cast<int>(scenario.entities.size());
    visitActions(scenario,
                 [&](const Action& action)
                 {
                     const auto* global = std::get_if<GlobalAction>(&action);
                     if (const auto* traffic = global ? std::get_if<TrafficAction>(global) : nullptr)
                         add(scenario, *traffic, seed);
                 });
    for (const GlobalAction& global : scenario.storyboard.init.globals)
        if (const auto* traffic = std::get_if<TrafficAction>(&global)) add(scenario, *traffic, seed);
}

void TrafficPlan::add(Scenario& scenario, const TrafficAction& action, std::uint64_t seed)
{
    const TrafficMix* const mix = mixOf(action);
    if (!mix) return;
    const std::string name = action.name.empty() ? "traffic" : action.name;
    RandomDraw draw(seed, name, static_cast<std::uint64_t>(_vehicles.size()));
    std::set<std::string> taken;
    for (const ScenarioObject& object : scenario.entities)
        taken.insert(object.name);
    std::vector<int>& vehicles = _vehicles[&action];
    int number = 0;
    for (int i = 0; i < countOf(action) && scenario.entities.size() < kMost; ++i)
    {
        ScenarioObject vehicle = vehicleOf(*mix, draw);
        vehicle.source = action.source;
        do
            vehicle.name = name + " " + std::to_string(++number);
        while (taken.contains(vehicle.name));
        vehicles.push_back(static_cast<int>(scenario.entities.size()));
        scenario.entities.push_back(std::move(vehicle));
    }
}

const std::vector<int>& TrafficPlan::vehiclesOf(const TrafficAction& action) const
{
    static const std::vector<int> kNone;
    const auto found = _vehicles.find(&action);
    return found == _vehicles.end() ? kNone : found->second;
}

} // namespace simulation
