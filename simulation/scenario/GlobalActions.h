// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "simulation/scenario/Position.h"
#include "simulation/scenario/SourceLine.h"

namespace simulation
{

/// Sets or changes a parameter (1.0, 1.1) or a variable (from 1.2 on).
struct SetValueAction
{
    static constexpr std::string_view kElement = "ParameterAction";

    enum class Change
    {
        set,
        add,
        multiply,
    };

    SourceLine source;
    std::string name;
    Change change = Change::set;
    std::string value;

    bool operator==(const SetValueAction&) const = default;
};

struct TrafficSignalStateAction
{
    static constexpr std::string_view kElement = "TrafficSignalStateAction";

    SourceLine source;
    std::string signal;
    std::string state;

    bool operator==(const TrafficSignalStateAction&) const = default;
};

/// Removes an entity, or puts one there.
struct EntityAction
{
    static constexpr std::string_view kElement = "EntityAction";

    SourceLine source;
    std::string entity;
    bool isDeleted = false;           ///< else added
    std::optional<Position> position; ///< where it is added

    bool operator==(const EntityAction&) const = default;
};

struct SetMonitorAction
{
    static constexpr std::string_view kElement = "SetMonitorAction";

    SourceLine source;
    std::string name;
    bool value = false;

    bool operator==(const SetMonitorAction&) const = default;
};

} // namespace simulation
