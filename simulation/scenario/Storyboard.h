// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "simulation/scenario/Action.h"
#include "simulation/scenario/Condition.h"

namespace simulation
{

/// Private actions of one entity at time 0.
struct InitPrivate
{
    SourceLine source;
    std::string entity;
    std::vector<PrivateAction> actions;

    bool operator==(const InitPrivate&) const = default;
};

struct Init
{
    std::vector<GlobalAction> globals;
    std::vector<InitPrivate> privates;

    bool operator==(const Init&) const = default;
};

struct NamedAction
{
    SourceLine source;
    std::string name;
    Action action;

    bool operator==(const NamedAction&) const = default;
};

enum class Priority
{
    overwrite, ///< `override` from 1.2 on: ends the other running events of the maneuver
    skip,      ///< does not start while another event of the maneuver runs
    parallel,
};

struct Event
{
    SourceLine source;
    std::string name;
    Priority priority = Priority::parallel;
    int maximumExecutionCount = 1;
    std::vector<NamedAction> actions;
    std::optional<Trigger> startTrigger; ///< absent: starts with its maneuver

    bool operator==(const Event&) const = default;
};

struct Maneuver
{
    SourceLine source;
    std::string name;
    std::vector<Event> events;

    bool operator==(const Maneuver&) const = default;
};

struct ManeuverGroup
{
    SourceLine source;
    std::string name;
    int maximumExecutionCount = 1;
    bool selectTriggeringEntities = false;
    std::vector<std::string> actors;
    std::vector<Maneuver> maneuvers;

    bool operator==(const ManeuverGroup&) const = default;
};

struct Act
{
    SourceLine source;
    std::string name;
    std::vector<ManeuverGroup> groups;
    std::optional<Trigger> startTrigger; ///< absent: starts at once
    std::optional<Trigger> stopTrigger;

    bool operator==(const Act&) const = default;
};

struct Story
{
    SourceLine source;
    std::string name;
    std::vector<Act> acts;

    bool operator==(const Story&) const = default;
};

struct Storyboard
{
    SourceLine source;
    Init init;
    std::vector<Story> stories;
    std::optional<Trigger> stopTrigger;

    bool operator==(const Storyboard&) const = default;
};

} // namespace simulation
