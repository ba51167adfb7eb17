// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "simulation/scenario/LongitudinalActions.h"
#include "simulation/scenario/Position.h"
#include "simulation/scenario/Trajectory.h"

namespace simulation
{

struct TeleportAction
{
    SourceLine source;
    Position position;

    bool operator==(const TeleportAction&) const = default;
};

struct FollowTrajectoryAction
{
    SourceLine source;
    Trajectory trajectory;
    std::optional<Timing> timing; ///< absent (TimeReference/None): the vertices' times are ignored
    FollowingMode mode = FollowingMode::position;
    double initialDistanceOffsetM = 0.0;

    bool operator==(const FollowTrajectoryAction&) const = default;
};

struct AssignRouteAction
{
    static constexpr std::string_view kElement = "AssignRouteAction";

    SourceLine source;
    Route route;

    bool operator==(const AssignRouteAction&) const = default;
};

/// Takes a road by chance in every junction.
struct RandomRouteAction
{
    static constexpr std::string_view kElement = "RandomRouteAction";

    SourceLine source;

    bool operator==(const RandomRouteAction&) const = default;
};

struct AcquirePositionAction
{
    static constexpr std::string_view kElement = "AcquirePositionAction";

    SourceLine source;
    Position position;

    bool operator==(const AcquirePositionAction&) const = default;
};

/// Reaches a place when another entity reaches its own.
struct SynchronizeAction
{
    static constexpr std::string_view kElement = "SynchronizeAction";

    SourceLine source;
    std::string master;
    Position masterPosition;
    Position position;
    double masterToleranceM = 1.0, toleranceM = 1.0;
    std::variant<std::monostate, AbsoluteTargetSpeed, RelativeTargetSpeed> finalSpeed; ///< nothing: any
    std::optional<double> steadyDistanceM, steadyTimeS; ///< of the final speed before the target; one of them

    bool operator==(const SynchronizeAction&) const = default;
};

/// Hands the entity to its controller; nothing: leaves that domain as it is.
struct ActivateControllerAction
{
    static constexpr std::string_view kElement = "ActivateControllerAction";

    SourceLine source;
    std::string controller; ///< its name; empty: the one assigned last
    std::optional<bool> longitudinal, lateral;

    bool operator==(const ActivateControllerAction&) const = default;
};

} // namespace simulation
