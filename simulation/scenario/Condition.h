// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "simulation/scenario/SourceLine.h"

namespace simulation
{

enum class Rule
{
    equalTo,
    greaterThan,
    lessThan,
    greaterOrEqual,
    lessOrEqual,
    notEqualTo,
};

/// Whether `left rule right` is true.
constexpr bool holds(double left, Rule rule, double right)
{
    switch (rule)
    {
    case Rule::equalTo:
        return left == right;
    case Rule::greaterThan:
        return left > right;
    case Rule::lessThan:
        return left < right;
    case Rule::greaterOrEqual:
        return left >= right;
    case Rule::lessOrEqual:
        return left <= right;
    case Rule::notEqualTo:
        return left != right;
    }
    return false;
}

struct SimulationTimeCondition
{
    double seconds = 0.0;
    Rule rule = Rule::greaterThan;

    bool operator==(const SimulationTimeCondition&) const = default;
};

enum class StoryboardElementType
{
    story,
    act,
    maneuverGroup,
    maneuver,
    event,
    action,
};

enum class StoryboardElementState
{
    standbyState,
    runningState,
    completeState,
    startTransition,
    endTransition,
    stopTransition,
    skipTransition,
};

struct StoryboardElementStateCondition
{
    StoryboardElementType type = StoryboardElementType::event;
    std::string element; ///< its name, or a path of names with `::` between them
    StoryboardElementState state = StoryboardElementState::completeState;

    bool operator==(const StoryboardElementStateCondition&) const = default;
};

using ConditionContent = std::variant<SimulationTimeCondition, StoryboardElementStateCondition, Unsupported>;

enum class ConditionEdge
{
    none,
    rising,
    falling,
    risingOrFalling,
};

struct Condition
{
    SourceLine source;
    std::string name;
    double delayS = 0.0;
    ConditionEdge edge = ConditionEdge::none;
    ConditionContent content;

    bool operator==(const Condition&) const = default;
};

/// True when all its conditions are true.
struct ConditionGroup
{
    std::vector<Condition> conditions;

    bool operator==(const ConditionGroup&) const = default;
};

/// Fires when one of its groups is true; a trigger without groups never fires.
struct Trigger
{
    SourceLine source;
    std::vector<ConditionGroup> groups;

    bool operator==(const Trigger&) const = default;
};

} // namespace simulation
