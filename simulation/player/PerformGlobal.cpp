// SPDX-License-Identifier: Apache-2.0
// What each global action does: one overload an action.
#include "simulation/parser/Expression.h"
#include "simulation/player/ScenePerformer.h"

namespace simulation
{

void ScenePerformer::carryOut(const EnvironmentAction& action)
{
    _environment->apply(action.environment, timeS());
}

void ScenePerformer::carryOut(const SetValueAction& action)
{
    std::string& value = _values[action.name];
    const std::optional<double> old = parseNumber(value);
    const std::optional<double> given = parseNumber(action.value);
    if (action.change == SetValueAction::Change::set || !old || !given)
        value = action.value;
    else
        value = formatNumber(action.change == SetValueAction::Change::add ? *old + *given : *old * *given);
}

void ScenePerformer::carryOut(const SetMonitorAction& action)
{
    _monitors[action.name] = action.value;
}

void ScenePerformer::carryOut(const TrafficSignalStateAction& action)
{
    _signals.setState(action.signal, action.state);
}

void ScenePerformer::carryOut(const TrafficSignalControllerAction& action)
{
    _signals.beginPhase(action, timeS());
}

/// What was running ends with the entity.
void ScenePerformer::carryOut(const EntityAction& action)
{
    const int entity = find(action.entity);
    if (entity < 0) return;
    actorOf(entity).isAbsent = action.isDeleted;
    if (action.isDeleted)
    {
        for (const ActionDomain domain : {ActionDomain::longitudinal, ActionDomain::lateral})
            end(entity, domain);
        if (actorOf(entity).isByPerson()) _external.vanish(static_cast<std::size_t>(entity), timeS());
        motion(entity).setSpeed(0.0, timeS());
    }
    else if (const auto placed = action.position ? _positions.place(*action.position) : std::nullopt)
        motion(entity).teleport(*placed, timeS());
}

} // namespace simulation
