// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/LaneCount.h"
#include "simulation/player/actions/LaneTransition.h"

namespace simulation
{

std::unique_ptr<RunningAction> startAction(const LaneChangeAction& action, ActionScene& scene, int actor)
{
    EntityMotion& motion = scene.motion(actor);
    if (!scene.roads() || !motion.state().place) return nullptr;
    int lane = action.lane;
    if (!action.entity.empty())
    {
        const int other = scene.find(action.entity);
        if (other < 0 || !scene.motion(other).state().place) return nullptr;
        const RoadPlace& reference = *scene.motion(other).state().place;
        lane = lanesBeside(reference.lane, looksForward(reference) ? action.lane : -action.lane);
    }
    RoadPlace target = *motion.state().place;
    if (!scene.roads()->putOnLane(target, lane, action.targetOffsetM)) return nullptr;
    const double amount = target.t - motion.state().place->t;
    return std::make_unique<LaneTransition>(
        LaneTransition::Course{
            lane, action.targetOffsetM, action.dynamics.shape, durationOf(action.dynamics, amount),
            action.dynamics.dimension == DynamicsDimension::distance, false, true, motion.takeOrder()},
        motion, *scene.roads());
}

} // namespace simulation
