// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Scenario.h"

#include <algorithm>

#include "simulation/scenario/ControllerKinds.h"
#include "simulation/scenario/VisitActions.h"

namespace simulation
{
namespace
{

bool isOnRoad(const Position& position)
{
    return !std::holds_alternative<WorldPosition>(position) &&
           !std::holds_alternative<GeoPosition>(position) &&
           !std::holds_alternative<RelativeObjectPosition>(position) &&
           !std::holds_alternative<RelativeWorldPosition>(position) &&
           !std::holds_alternative<TrajectoryPosition>(position) &&
           !std::holds_alternative<Unsupported>(position);
}

std::optional<SourceLine> placeOnRoad(const PrivateAction& action)
{
    const auto* teleport = std::get_if<TeleportAction>(&action);
    return teleport && isOnRoad(teleport->position) ? std::optional(teleport->source) : std::nullopt;
}

std::optional<SourceLine> roadsFor(const PrivateAction& action)
{
    if (const auto line = placeOnRoad(action)) return line;
    if (const auto* change = std::get_if<LaneChangeAction>(&action)) return change->source;
    if (const auto* offset = std::get_if<LaneOffsetAction>(&action)) return offset->source;
    return std::nullopt;
}

/// The first line that a function finds in the actions of entities.
template<class Find>
std::optional<SourceLine> firstLine(const Scenario& scenario, Find find)
{
    for (const InitPrivate& initial : scenario.storyboard.init.privates)
        for (const PrivateAction& action : initial.actions)
            if (const auto line = find(action)) return line;
    std::optional<SourceLine> line;
    visitActions(scenario,
                 [&](const Action& action)
                 {
                     const auto* own = std::get_if<PrivateAction>(&action);
                     if (!line && own) line = find(*own);
                 });
    return line;
}

/// A driver goes along the roads where there are some.
std::optional<SourceLine> driverLine(const Scenario& scenario)
{
    for (const ScenarioObject& object : scenario.entities)
        for (const Controller& controller : object.controllers)
            if (const auto* const kind = controller.played(); kind && kind->goesByRoads)
                return controller.source;
    return std::nullopt;
}

std::optional<SourceLine> lineOfTraffic(const GlobalAction& action)
{
    const auto* traffic = std::get_if<TrafficAction>(&action);
    return traffic ? std::optional(traffic->source) : std::nullopt;
}

std::optional<SourceLine> trafficLine(const Scenario& scenario)
{
    std::optional<SourceLine> line;
    for (const GlobalAction& action : scenario.storyboard.init.globals)
        if (!line) line = lineOfTraffic(action);
    visitActions(scenario,
                 [&](const Action& action)
                 {
                     const auto* global = std::get_if<GlobalAction>(&action);
                     if (!line && global) line = lineOfTraffic(*global);
                 });
    return line;
}

} // namespace

int Scenario::entityIndex(const std::string& name) const
{
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [&](const ScenarioObject& object) { return object.name == name; });
    return found == entities.end() ? -1 : static_cast<int>(found - entities.begin());
}

bool Scenario::isConsistent() const
{
    const auto known = [this](const std::string& name) { return entityIndex(name) >= 0; };
    for (const InitPrivate& initial : storyboard.init.privates)
        if (!known(initial.entity)) return false;
    for (const Story& story : storyboard.stories)
        for (const Act& act : story.acts)
            for (const ManeuverGroup& group : act.groups)
                if (!std::all_of(group.actors.begin(), group.actors.end(), known)) return false;
    return true;
}

std::optional<SourceLine> Scenario::needsRoads() const
{
    if (!roadNetwork.logicFile.empty())
    {
        if (const auto line = trafficLine(*this)) return line;
        if (const auto line = driverLine(*this)) return line;
    }
    return firstLine(*this, roadsFor);
}

std::optional<SourceLine> Scenario::placesOnRoads() const
{
    return firstLine(*this, placeOnRoad);
}

} // namespace simulation
