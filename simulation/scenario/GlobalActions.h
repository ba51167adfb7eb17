// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

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

/// Removes an entity.
struct EntityAction
{
    static constexpr std::string_view kElement = "EntityAction";

    SourceLine source;
    std::string entity;
    bool isDeleted = false; ///< else added, which is not played

    bool operator==(const EntityAction&) const = default;
};

} // namespace simulation
