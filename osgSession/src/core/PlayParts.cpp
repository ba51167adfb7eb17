// SPDX-License-Identifier: Apache-2.0
#include "PlayParts.h"

#include <algorithm>

#include "simulation/parser/ParseScenario.h"

namespace osgSession::core
{

namespace
{

constexpr int kMostStepsPerSecond = 10'000;

bool hasEntity(const simulation::Scenario& scenario, const std::string& name)
{
    return std::any_of(scenario.entities.begin(), scenario.entities.end(),
                       [&](const simulation::ScenarioObject& object) { return object.name == name; });
}

} // namespace

foundation::Result<std::map<std::string, DrivenVehicle>>
makeDriven(const PlaySettings& settings, const simulation::Scenario& scenario,
           const std::shared_ptr<const simulation::Ground>& ground,
           const std::optional<simulation::Geodetic>& origin)
{
    std::map<std::string, DrivenVehicle> driven;
    for (const auto& [name, file] : settings.driven)
    {
        if (!hasEntity(scenario, name))
            return foundation::Error{settings.scenario.string(), "there is no entity '" + name + "' to drive",
                                     "name one of its Entities"};
        auto vehicle = DrivenVehicle::create(file, ground, origin, settings.seed);
        if (!vehicle) return vehicle.error();
        driven.emplace(name, std::move(*vehicle));
    }
    return driven;
}

std::map<std::string, std::shared_ptr<simulation::ExternalMotion>>
motionsOf(const std::map<std::string, DrivenVehicle>& driven)
{
    std::map<std::string, std::shared_ptr<simulation::ExternalMotion>> motions;
    for (const auto& [name, vehicle] : driven)
        motions.emplace(name, vehicle.motion());
    return motions;
}

foundation::Outcome checkSteps(const PlaySettings& settings)
{
    if (settings.stepsPerSecond >= 1 && settings.stepsPerSecond <= kMostStepsPerSecond)
        return foundation::success();
    return foundation::Error{"stepsPerSecond",
                             std::to_string(settings.stepsPerSecond) + " is no usable number of steps",
                             "give 1 to 10000, for example 120"};
}

foundation::Result<simulation::Scenario> readForPlay(const PlaySettings& settings,
                                                     std::vector<std::string>& notes)
{
    if (const auto usable = checkSteps(settings); !usable) return usable.error();
    auto parsed =
        simulation::readScenario(settings.scenario, {.tolerant = true, .parameters = settings.parameters});
    if (!parsed) return parsed.error();
    for (const simulation::Problem& problem : parsed->problems)
    {
        if (problem.kind == simulation::Problem::Kind::invalid) return problem.error;
        notes.push_back(problem.error.message());
    }
    return std::move(parsed->scenario);
}

} // namespace osgSession::core
