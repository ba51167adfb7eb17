// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "simulation/environment/DateTime.h"
#include "simulation/scenario/EntityCondition.h"
#include "simulation/scenario/Rule.h"
#include "simulation/scenario/SourceLine.h"

namespace simulation
{

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

/// Compares a parameter (1.0, 1.1), a variable (from 1.2 on) or a value that the user names.
struct ValueCondition
{
    static constexpr std::string_view kElement = "ParameterCondition";

    std::string name;
    std::string value;
    Rule rule = Rule::greaterThan;

    bool operator==(const ValueCondition&) const = default;
};

struct TrafficSignalCondition
{
    static constexpr std::string_view kElement = "TrafficSignalCondition";

    std::string signal;
    std::string state;

    bool operator==(const TrafficSignalCondition&) const = default;
};

struct TrafficSignalControllerCondition
{
    static constexpr std::string_view kElement = "TrafficSignalControllerCondition";

    std::string controller;
    std::string phase;

    bool operator==(const TrafficSignalControllerCondition&) const = default;
};

struct TimeOfDayCondition
{
    static constexpr std::string_view kElement = "TimeOfDayCondition";

    DateTime dateTime;
    Rule rule = Rule::greaterThan;

    bool operator==(const TimeOfDayCondition&) const = default;
};

using ConditionContentKinds =
    std::variant<SimulationTimeCondition, StoryboardElementStateCondition, ValueCondition,
                 TrafficSignalCondition, TrafficSignalControllerCondition, TimeOfDayCondition,
                 EntityCondition, Unsupported>;

/// What a condition asks. Compiled once, as Position is.
struct ConditionContent : ConditionContentKinds
{
    using ConditionContentKinds::variant;

    ConditionContent();
    ConditionContent(const ConditionContent&);
    ConditionContent(ConditionContent&&) noexcept;
    ConditionContent& operator=(const ConditionContent&);
    ConditionContent& operator=(ConditionContent&&) noexcept;
    ~ConditionContent();

    bool operator==(const ConditionContent&) const;
};

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
