// SPDX-License-Identifier: Apache-2.0
#include "simulation/scenario/Scenario.h"

#include <algorithm>

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

std::optional<SourceLine> roadsFor(const PrivateAction& action)
{
    if (const auto* teleport = std::get_if<TeleportAction>(&action))
        if (isOnRoad(teleport->position)) return teleport->source;
    if (const auto* change = std::get_if<LaneChangeAction>(&action)) return change->source;
    if (const auto* offset = std::get_if<LaneOffsetAction>(&action)) return offset->source;
    return std::nullopt;
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
    for (const InitPrivate& initial : storyboard.init.privates)
        for (const PrivateAction& action : initial.actions)
            if (const auto line = roadsFor(action)) return line;
    for (const Story& story : storyboard.stories)
        for (const Act& act : story.acts)
            for (const ManeuverGroup& group : act.groups)
                for (const Maneuver& maneuver : group.maneuvers)
                    for (const Event& event : maneuver.events)
                        for (const NamedAction& named : event.actions)
                            if (const auto* action = std::get_if<PrivateAction>(&named.action))
                                if (const auto line = roadsFor(*action)) return line;
    return std::nullopt;
}

} // namespace simulation
