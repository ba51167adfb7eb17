// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/TriggerWatch.h"

#include <algorithm>

#include "simulation/parser/Expression.h"

namespace simulation
{
namespace
{

/// A time that a decimal delay and a binary step both mean, but write differently, must count as reached.
constexpr double kSameInstantS = 1e-9;

/// Numbers are compared as numbers, other texts only for equality.
bool isTrue(const ValueCondition& condition, const ConditionFacts& facts)
{
    if (!facts.values) return false;
    const auto found = facts.values->find(condition.name);
    if (found == facts.values->end()) return false;
    const std::optional<double> left = parseNumber(found->second);
    const std::optional<double> right = parseNumber(condition.value);
    if (left && right) return nearlyHolds(*left, condition.rule, *right);
    const bool isSame = found->second == condition.value;
    return condition.rule == Rule::equalTo ? isSame : condition.rule == Rule::notEqualTo && !isSame;
}

bool isSo(const std::map<std::string, std::string>* states, const std::string& name,
          const std::string& wanted)
{
    if (!states) return false;
    const auto found = states->find(name);
    return found != states->end() && found->second == wanted;
}

bool isTrue(const ConditionContent& content, const ConditionFacts& facts)
{
    if (const auto* time = std::get_if<SimulationTimeCondition>(&content))
        return holds(facts.timeS, time->rule, time->seconds);
    if (const auto* state = std::get_if<StoryboardElementStateCondition>(&content))
        return facts.elementIs(*state);
    if (const auto* entity = std::get_if<EntityCondition>(&content)) return holdsFor(*entity, facts.entities);
    if (const auto* value = std::get_if<ValueCondition>(&content)) return isTrue(*value, facts);
    if (const auto* signal = std::get_if<TrafficSignalCondition>(&content))
        return isSo(facts.signals, signal->signal, signal->state);
    if (const auto* controller = std::get_if<TrafficSignalControllerCondition>(&content))
        return isSo(facts.phases, controller->controller, controller->phase);
    if (const auto* instant = std::get_if<TimeOfDayCondition>(&content); instant && facts.dateTime)
        return holds(static_cast<double>(facts.dateTime->unixMilliseconds), instant->rule,
                     static_cast<double>(instant->dateTime.unixMilliseconds));
    return false;
}

bool edgeOf(ConditionEdge edge, bool hasLast, bool last, bool now)
{
    if (edge == ConditionEdge::none) return now;
    const bool rises = hasLast && now && !last;
    const bool falls = hasLast && !now && last;
    if (edge == ConditionEdge::rising) return rises;
    if (edge == ConditionEdge::falling) return falls;
    return rises || falls;
}

} // namespace

TriggerWatch::TriggerWatch(const Trigger& trigger, bool keepsEntities)
    : _trigger(&trigger), _keepsEntities(keepsEntities)
{
    reset();
}

void TriggerWatch::reset()
{
    std::size_t count = 0;
    for (const ConditionGroup& group : _trigger->groups)
        count += group.conditions.size();
    _memories.assign(count, {});
}

bool TriggerWatch::update(const ConditionFacts& facts)
{
    bool fires = false;
    std::size_t index = 0;
    _triggering.clear();
    for (const ConditionGroup& group : _trigger->groups)
    {
        const std::size_t first = index;
        bool all = !group.conditions.empty();
        for (const Condition& condition : group.conditions)
        {
            // Every condition is looked at in every step: its history must not depend on the others.
            const bool value = updateCondition(condition, _memories[index++], facts);
            all = all && value;
        }
        fires = fires || all;
        if (all && _keepsEntities) addTriggering(first, index);
    }
    return fires;
}

void TriggerWatch::addTriggering(std::size_t first, std::size_t last)
{
    for (std::size_t i = first; i < last; ++i)
        for (const std::string& entity : _memories[i].triggering)
            if (std::find(_triggering.begin(), _triggering.end(), entity) == _triggering.end())
                _triggering.push_back(entity);
}

bool TriggerWatch::updateCondition(const Condition& condition, Memory& memory, const ConditionFacts& facts)
{
    // On roads, conditions on entities are first looked at when these have moved, as in esmini.
    const bool isEarly = facts.entities.roads && facts.timeS <= 0.0;
    if (isEarly && std::holds_alternative<EntityCondition>(condition.content)) return false;
    const bool now = isTrue(condition.content, facts);
    const bool value = edgeOf(condition.edge, memory.hasLast, memory.last, now);
    const auto* const onEntities =
        _keepsEntities ? std::get_if<EntityCondition>(&condition.content) : nullptr;
    std::vector<std::string> held =
        onEntities ? triggeringEntities(*onEntities, facts.entities) : std::vector<std::string>();
    // At a falling edge they are those of the step before.
    memory.triggering = !now && value ? memory.entities : held;
    memory.entities = std::move(held);
    memory.hasLast = true;
    memory.last = now;
    if (condition.delayS <= 0.0) return value;
    if (memory.changes.empty() || memory.changes.back().value != value ||
        memory.changes.back().entities != memory.triggering)
        memory.changes.push_back({facts.timeS, value, memory.triggering});
    const double then = facts.timeS - condition.delayS + kSameInstantS;
    while (memory.changes.size() > 1 && memory.changes[1].timeS <= then)
        memory.changes.pop_front();
    memory.triggering = memory.changes.front().entities;
    return memory.changes.front().timeS <= then && memory.changes.front().value;
}

} // namespace simulation
