// SPDX-License-Identifier: Apache-2.0
#include "view/WatchedEntity.h"

#include <algorithm>
#include <array>
#include <functional>
#include <set>

#include <foundation/SmallLetters.h>

namespace trainer
{

namespace
{

using simulation::ScenarioObject;
using simulation::Vehicle;

bool isOwn(const ScenarioObject& object)
{
    static constexpr std::array kOwn{"ego", "ownship", "hero"};
    const std::string name = foundation::inSmallLetters(object.name);
    return std::any_of(kOwn.begin(), kOwn.end(),
                       [&](const char* own) { return name.compare(0, std::string(own).size(), own) == 0; });
}

bool isThing(const ScenarioObject& object)
{
    return !object.isAirborne() && !std::holds_alternative<Vehicle>(object.object) &&
           !std::holds_alternative<simulation::Pedestrian>(object.object);
}

/// The entities that others tow, by name.
std::set<std::string> towedOf(const simulation::Scenario& scenario)
{
    std::set<std::string> towed;
    for (const ScenarioObject& object : scenario.entities)
        if (const auto* vehicle = std::get_if<Vehicle>(&object.object))
            if (!vehicle->trailerEntity.empty()) towed.insert(vehicle->trailerEntity);
    return towed;
}

std::size_t defaultOne(const simulation::Scenario& scenario)
{
    const std::vector<ScenarioObject>& entities = scenario.entities;
    const std::set<std::string> towed = towedOf(scenario);
    const auto drives = [&](const ScenarioObject& object)
    { return std::holds_alternative<Vehicle>(object.object) && !towed.contains(object.name); };
    const auto first = [&](const auto& fits)
    { return std::find_if(entities.begin(), entities.end(), fits) - entities.begin(); };
    for (const auto found : {first(isOwn), first(drives), first(std::not_fn(isThing))})
        if (const auto index = static_cast<std::size_t>(found); index < entities.size()) return index;
    return 0;
}

} // namespace

foundation::Result<std::size_t> watchedEntity(const simulation::Scenario& scenario, const std::string& name)
{
    if (name.empty()) return defaultOne(scenario);
    std::string names;
    for (std::size_t i = 0; i < scenario.entities.size(); ++i)
    {
        if (scenario.entities[i].name == name) return i;
        names += (i > 0 ? ", " : "") + scenario.entities[i].name;
    }
    return foundation::Error{"--eye-entity", "there is no entity '" + name + "'", "write one of: " + names};
}

TrainSize trainOf(const simulation::Scenario& scenario, std::size_t entity)
{
    TrainSize size;
    double originM = 0.0; ///< of the vehicle in question, from that of the first one
    int at = static_cast<int>(entity);
    // A train that bites its tail ends there, and none is longer than there are entities.
    for (std::size_t i = 0; i < scenario.entities.size() && at >= 0; ++i)
    {
        const ScenarioObject& object = scenario.entities[static_cast<std::size_t>(at)];
        const simulation::BoundingBox& box = object.box();
        size.behindM = std::max(size.behindM, 0.5 * box.lengthM - box.centre.x - originM);
        size.heightM = std::max(size.heightM, box.centre.z + 0.5 * box.heightM);
        const auto* vehicle = std::get_if<Vehicle>(&object.object);
        at = vehicle && !vehicle->trailerEntity.empty() ? scenario.entityIndex(vehicle->trailerEntity) : -1;
        const auto* towed =
            at >= 0 ? std::get_if<Vehicle>(&scenario.entities[static_cast<std::size_t>(at)].object) : nullptr;
        if (!towed || at == static_cast<int>(entity)) break;
        originM += vehicle->trailerHitchDxM.value_or(0.0) - towed->trailerCouplerDxM.value_or(0.0);
    }
    return size;
}

} // namespace trainer
