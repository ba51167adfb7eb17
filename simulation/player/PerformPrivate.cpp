// SPDX-License-Identifier: Apache-2.0
// What each private action does: one overload an action.
#include <algorithm>

#include "simulation/player/ScenePerformer.h"
#include "simulation/player/ShapeSampling.h"
#include "simulation/player/controllers/PedalDrive.h"
#include "simulation/player/controllers/SpeedControllers.h"
#include "simulation/road/RouteWay.h"

namespace simulation
{

namespace
{

bool movesSideways(const PrivateAction& action)
{
    return std::holds_alternative<LaneChangeAction>(action) ||
           std::holds_alternative<LaneOffsetAction>(action) ||
           std::holds_alternative<LateralDistanceAction>(action) ||
           std::holds_alternative<FollowTrajectoryAction>(action);
}

} // namespace

template<class Action>
ActionTicket ScenePerformer::start(const Action& action, int actor, ActionDomain domain)
{
    end(actor, domain);
    std::unique_ptr<RunningAction> running = startAction(action, *this, actor);
    if (!running) return {};
    _running.push_back({++_lastNumber, actor, std::move(running)});
    return {actor, _lastNumber, true};
}

ActionTicket ScenePerformer::carryOut(const SpeedAction& action, int actor)
{
    if (std::holds_alternative<RelativeTargetSpeed>(action.target))
    {
        const bool isContinuous = std::get<RelativeTargetSpeed>(action.target).isContinuous;
        const ActionTicket ticket = start(action, actor, ActionDomain::longitudinal);
        if (isContinuous || !ticket.isRunningAction) return ticket;
        end(actor, ActionDomain::longitudinal);
        return {actor, motion(actor).speedTicket()};
    }
    end(actor, ActionDomain::longitudinal);
    return {actor, motion(actor).startSpeed(action, timeS())};
}

/// The vertices are placed now, when the entities that they refer to are known.
ActionTicket ScenePerformer::carryOut(const FollowTrajectoryAction& action, int actor)
{
    FollowTrajectoryAction placed = action;
    const bool isCurve = !std::holds_alternative<Polyline>(action.trajectory.shape);
    if (isCurve || _roads)
    {
        auto polyline = sampledShape(action.trajectory.shape, _positions, &motion(actor).state());
        if (!polyline) return {};
        placed.trajectory.shape = std::move(*polyline);
        if (isCurve || placed.mode == FollowingMode::follow) placed.mode = FollowingMode::straight;
    }
    if (TrajectoryRun::obstacle(placed, *_frame)) return {};
    end(actor, ActionDomain::lateral);
    if (placed.timing) end(actor, ActionDomain::longitudinal);
    return {actor, motion(actor).startTrajectory(placed, timeS())};
}

ActionTicket ScenePerformer::carryOut(const LaneChangeAction& action, int actor)
{
    return start(action, actor, ActionDomain::lateral);
}

ActionTicket ScenePerformer::carryOut(const LaneOffsetAction& action, int actor)
{
    return start(action, actor, ActionDomain::lateral);
}

ActionTicket ScenePerformer::carryOut(const LateralDistanceAction& action, int actor)
{
    return start(action, actor, ActionDomain::lateral);
}

ActionTicket ScenePerformer::carryOut(const LongitudinalDistanceAction& action, int actor)
{
    return start(action, actor, ActionDomain::longitudinal);
}

ActionTicket ScenePerformer::carryOut(const SpeedProfileAction& action, int actor)
{
    return start(action, actor, ActionDomain::longitudinal);
}

ActionTicket ScenePerformer::carryOut(const SynchronizeAction& action, int actor)
{
    return start(action, actor, ActionDomain::longitudinal);
}

ActionTicket ScenePerformer::carryOut(const TeleportAction& action, int actor)
{
    const auto placed = _positions.place(action.position);
    if (!placed) return {};
    motion(actor).teleport(*placed, timeS());
    _external.restart(static_cast<std::size_t>(actor), timeS());
    if (_roads && timeS() > 0.0) motion(actor).standForAStep(); // as in esmini (decision 30)
    return {};
}

ActionTicket ScenePerformer::carryOut(const AssignRouteAction& action, int actor)
{
    if (!_roads) return {};
    RandomDraw draw(_traffic.seed(), _scenario->entities[static_cast<std::size_t>(actor)].name, ++_drawn);
    if (auto way = wayOfRoute(*_roads, action.route, &draw)) motion(actor).setWay(std::move(*way));
    return {};
}

ActionTicket ScenePerformer::carryOut(const AcquirePositionAction& action, int actor)
{
    const auto placed = _positions.place(action.position);
    const EntityState& state = motion(actor).state();
    if (!_roads || !placed || !placed->place || !state.place) return {};
    if (auto way = wayBetween(*_roads, *state.place, *placed->place)) motion(actor).setWay(std::move(*way));
    return {};
}

ActionTicket ScenePerformer::carryOut(const ActivateControllerAction& action, int actor)
{
    activate(action.controller, {action.longitudinal, action.lateral}, actor);
    return {};
}

ActionTicket ScenePerformer::carryOut(const AssignControllerAction& action, int actor)
{
    actorOf(actor).controllers.push_back(action.controller);
    activate(action.controller.name, {action.longitudinal, action.lateral}, actor);
    if (action.overrides) carryOut(*action.overrides, actor);
    return {};
}

ActionTicket ScenePerformer::carryOut(const VisibilityAction& action, int actor)
{
    actorOf(actor).isHidden = !action.inPictures;
    return {};
}

ActionTicket ScenePerformer::carryOut(const LightStateAction& action, int actor)
{
    actorOf(actor).lamps[action.light] = {action.mode, timeS(), action.onS, action.offS};
    return {};
}

ActionTicket ScenePerformer::carryOut(const TrailerAction& action, int actor)
{
    _trailers.couple(actor, find(action.trailer));
    return {};
}

/// Those of several parts go on beside one another.
ActionTicket ScenePerformer::carryOut(const AnimationAction& action, int actor)
{
    std::unique_ptr<RunningAction> running = startAction(action, *this, actor);
    if (running->step(*this, motion(actor))) return {};
    _running.push_back({++_lastNumber, actor, std::move(running)});
    return {actor, _lastNumber, true};
}

ActionTicket ScenePerformer::carryOut(const OverrideAction& action, int actor)
{
    Actor& own = actorOf(actor);
    own.controls.take(action);
    const double speed = own.motion.state().speedMps;
    own.pedals = own.controls.isAny() ? std::make_unique<PedalDrive>(own.controls, speed) : nullptr;
    if (own.pedals)
        end(actor, ActionDomain::longitudinal);
    else if (own.speed)
        activate("", {true, std::nullopt}, actor); // it begins at the speed of now
    return {};
}

ActionTicket ScenePerformer::carryOut(const RandomRouteAction&, int actor)
{
    const std::string& name = _scenario->entities[static_cast<std::size_t>(actor)].name;
    motion(actor).turnAtRandom(RandomDraw(_traffic.seed(), name, ++_drawn));
    return {};
}

/// Whether a controller has hold of what the action would change. It hears which speed is asked for.
bool ScenePerformer::isHeld(const PrivateAction& action, int actor)
{
    Actor& own = actorOf(actor);
    if (own.isExternal() && movesSideways(action)) return own.vehicle.isLateral;
    if (!own.isSpeedHeld()) return false;
    if (const auto* content = std::get_if<SpeedAction>(&action))
    {
        const auto* const target = std::get_if<AbsoluteTargetSpeed>(&content->target);
        if (target)
        {
            own.askedMps = target->speedMps;
            own.mover()->askForSpeed(target->speedMps);
        }
        return true;
    }
    return std::holds_alternative<LongitudinalDistanceAction>(action) ||
           std::holds_alternative<SpeedProfileAction>(action) ||
           std::holds_alternative<SynchronizeAction>(action);
}

/// Of several controllers the one of that name, else the one assigned last; null: there is none.
const Controller* ScenePerformer::controllerOf(const std::string& controller, int actor) const
{
    const std::vector<Controller>& known = _actors[static_cast<std::size_t>(actor)].controllers;
    if (known.empty()) return nullptr;
    const auto named = std::find_if(known.begin(), known.end(),
                                    [&](const Controller& one) {
                                        return one.name == controller ||
                                               (!controller.empty() && one.objectName == controller);
                                    });
    return named != known.end() ? &*named : &known.back();
}

/// A controller with physics moves the entity; any other one its speed alone.
void ScenePerformer::activate(const std::string& name, const ExternalControl::Wish& wish, int actor)
{
    const auto index = static_cast<std::size_t>(actor);
    Actor& own = actorOf(actor);
    const Controller* const controller = controllerOf(name, actor);
    if (controller && controller->isManual() && asksPerson(*controller, wish, actor)) return;
    if (controller && controller->hasPhysics())
    {
        own.speed.reset();
        _external.wish(index, *controller, wish, timeS());
        for (const ActionDomain domain : {ActionDomain::longitudinal, ActionDomain::lateral})
            if (own.vehicle.holds(domain)) end(actor, domain);
        return;
    }
    if (wish.longitudinal.value_or(false)) _external.release(index, timeS());
    if (!wish.longitudinal) return;
    own.speed.reset();
    if (!*wish.longitudinal || !controller) return;
    own.speed = makeSpeedController(*controller, own.motion.state().speedMps);
    if (own.speed) end(actor, ActionDomain::longitudinal);
}

} // namespace simulation
