// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simulation/player/EntityMotion.h"
#include "simulation/player/PositionSolver.h"
#include "simulation/player/Traffic.h"
#include "simulation/scenario/Action.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

class JunctionKeeper;

/// What an action may ask and change while it runs.
class ActionScene
{
public:
    virtual ~ActionScene() = default;

    virtual double timeS() const = 0;
    virtual double stepS() const = 0;
    virtual const RoadScene* roads() const = 0;
    virtual const PositionSolver& positions() const = 0;
    virtual const Scenario& scenario() const = 0;
    virtual EntityMotion& motion(int entity) = 0;

    /// Whether an entity is there: it is not before it is added and after it is deleted.
    virtual bool isPresent(int entity) const = 0;

    /// The share of the vehicles' greatest deceleration that the road leaves them: its friction, at most 1.
    virtual double grip() const = 0;

    /// The states of traffic signals, by id.
    virtual const std::map<std::string, std::string>& signalStates() const = 0;

    /// The others as an entity with physics sees them: all as they were before the step.
    virtual Traffic trafficOf(int entity) const = 0;

    /// Who may drive into the junctions of the roads; null without roads.
    virtual std::shared_ptr<JunctionKeeper> junctions() = 0;

    /// Returns the index of an entity, or -1.
    virtual int find(const std::string& entity) const = 0;
};

/// Which part of the motion of an entity an action has hold of: a new action ends those that hold the same.
enum class ActionDomain
{
    longitudinal,
    lateral,
    looks, ///< no motion: such actions do not end one another
};

/// A private action that lasts. It is stepped at the start of each step after the one in which it began,
/// before entities move.
class RunningAction
{
public:
    virtual ~RunningAction() = default;

    virtual ActionDomain domain() const = 0;

    /// Carries the action on to the time of the scene. Returns whether it is done.
    virtual bool step(ActionScene& scene, EntityMotion& actor) = 0;
};

/// Starts an action on an entity. Returns nothing for one that is done at once, or that cannot be performed.
std::unique_ptr<RunningAction> startAction(const LaneChangeAction& action, ActionScene& scene, int actor);
std::unique_ptr<RunningAction> startAction(const LaneOffsetAction& action, ActionScene& scene, int actor);
std::unique_ptr<RunningAction> startAction(const LateralDistanceAction& action, ActionScene& scene,
                                           int actor);
std::unique_ptr<RunningAction> startAction(const LongitudinalDistanceAction& action, ActionScene& scene,
                                           int actor);
std::unique_ptr<RunningAction> startAction(const SpeedProfileAction& action, ActionScene& scene, int actor);
std::unique_ptr<RunningAction> startAction(const SynchronizeAction& action, ActionScene& scene, int actor);
std::unique_ptr<RunningAction> startAction(const SpeedAction& action, ActionScene& scene, int actor);
std::unique_ptr<RunningAction> startAction(const AnimationAction& action, ActionScene& scene, int actor);

} // namespace simulation
