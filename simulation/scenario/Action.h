// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "simulation/scenario/Environment.h"
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

enum class DynamicsShape
{
    step,
    linear,
    cubic,
    sinusoidal,
};

enum class DynamicsDimension
{
    time,     ///< seconds
    distance, ///< metres
    rate,     ///< metres per second, per second
};

struct TransitionDynamics
{
    DynamicsShape shape = DynamicsShape::step;
    DynamicsDimension dimension = DynamicsDimension::time;
    double value = 0.0;

    bool operator==(const TransitionDynamics&) const = default;
};

struct AbsoluteTargetSpeed
{
    double speedMps = 0.0;

    bool operator==(const AbsoluteTargetSpeed&) const = default;
};

using SpeedTarget = std::variant<AbsoluteTargetSpeed, Unsupported>;

struct SpeedAction
{
    SourceLine source;
    TransitionDynamics dynamics;
    SpeedTarget target;

    bool operator==(const SpeedAction&) const = default;
};

struct EnvironmentAction
{
    SourceLine source;
    Environment environment;

    bool operator==(const EnvironmentAction&) const = default;
};

/// Actions on one entity; they grow here.
using PrivateAction = std::variant<TeleportAction, FollowTrajectoryAction, SpeedAction, Unsupported>;

/// Actions on the scene as a whole.
using GlobalAction = std::variant<EnvironmentAction, Unsupported>;

using Action = std::variant<PrivateAction, GlobalAction>;

} // namespace simulation
