// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

#include "simulation/scenario/AppearanceActions.h"
#include "simulation/scenario/Environment.h"
#include "simulation/scenario/GlobalActions.h"
#include "simulation/scenario/LateralActions.h"
#include "simulation/scenario/LongitudinalActions.h"
#include "simulation/scenario/OverrideAction.h"
#include "simulation/scenario/RoutingActions.h"
#include "simulation/scenario/TrafficActions.h"
#include "simulation/scenario/TrafficSignals.h"
#include "simulation/scenario/Trajectory.h"

namespace simulation
{

struct EnvironmentAction
{
    SourceLine source;
    Environment environment;

    bool operator==(const EnvironmentAction&) const = default;
};

/// Shows or hides an entity.
struct VisibilityAction
{
    static constexpr std::string_view kElement = "VisibilityAction";

    SourceLine source;
    bool inPictures = true, inTraffic = true, inSensors = true;

    bool operator==(const VisibilityAction&) const = default;
};

/// Actions on one entity; they grow here.
using PrivateActionKinds =
    std::variant<TeleportAction, FollowTrajectoryAction, SpeedAction, SpeedProfileAction,
                 LongitudinalDistanceAction, LaneChangeAction, LaneOffsetAction, LateralDistanceAction,
                 AssignRouteAction, AcquirePositionAction, SynchronizeAction, ActivateControllerAction,
                 AssignControllerAction, VisibilityAction, LightStateAction, TrailerAction, AnimationAction,
                 OverrideAction, RandomRouteAction, Unsupported>;

/// An action on one entity. Compiled once, as Position is.
struct PrivateAction : PrivateActionKinds
{
    using PrivateActionKinds::variant;

    PrivateAction();
    PrivateAction(const PrivateAction&);
    PrivateAction(PrivateAction&&) noexcept;
    PrivateAction& operator=(const PrivateAction&);
    PrivateAction& operator=(PrivateAction&&) noexcept;
    ~PrivateAction();

    bool operator==(const PrivateAction&) const;
};

/// Actions on the scene as a whole.
using GlobalActionKinds =
    std::variant<EnvironmentAction, SetValueAction, SetMonitorAction, TrafficSignalStateAction,
                 TrafficSignalControllerAction, EntityAction, TrafficAction, Unsupported>;

/// An action on the scene as a whole. Compiled once, as Position is.
struct GlobalAction : GlobalActionKinds
{
    using GlobalActionKinds::variant;

    GlobalAction();
    GlobalAction(const GlobalAction&);
    GlobalAction(GlobalAction&&) noexcept;
    GlobalAction& operator=(const GlobalAction&);
    GlobalAction& operator=(GlobalAction&&) noexcept;
    ~GlobalAction();

    bool operator==(const GlobalAction&) const;
};

using Action = std::variant<PrivateAction, GlobalAction>;

} // namespace simulation
