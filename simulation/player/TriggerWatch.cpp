// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/TriggerWatch.h"

namespace simulation
{
namespace
{

/// A time that a decimal delay and a binary step both mean, but write differently, must count as reached.
constexpr double kSameInstantS = 1e-9;

bool isTrue(const ConditionContent& content, const ConditionFacts& facts)
{
    if (const auto* time = std::get_if<SimulationTimeCondition>(&content))
        return holds(facts.timeS, time->rule, time->seconds);
    if (const auto* state = std::get_if<StoryboardElementStateCondition>(&content))
        return facts.elementIs(*state);
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

TriggerWatch::TriggerWatch(const Trigger& trigger) : _trigger(&trigger)
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
    for (const ConditionGroup& group : _trigger->groups)
    {
        bool all = !group.conditions.empty();
        for (const Condition& condition : group.conditions)
        {
            // Every condition is looked at in every step: its history must not depend on the others.
            const bool value = updateCondition(condition, _memories[index++], facts);
            all = all && value;
        }
        fires = fires || all;
    }
    return fires;
}

bool TriggerWatch::updateCondition(const Condition& condition, Memory& memory, const ConditionFacts& facts)
{
    const bool now = isTrue(condition.content, facts);
    const bool value = edgeOf(condition.edge, memory.hasLast, memory.last, now);
    memory.hasLast = true;
    memory.last = now;
    if (condition.delayS <= 0.0) return value;
    if (memory.changes.empty() || memory.changes.back().value != value)
        memory.changes.push_back({facts.timeS, value});
    const double then = facts.timeS - condition.delayS + kSameInstantS;
    while (memory.changes.size() > 1 && memory.changes[1].timeS <= then)
        memory.changes.pop_front();
    return memory.changes.front().timeS <= then && memory.changes.front().value;
}

} // namespace simulation
