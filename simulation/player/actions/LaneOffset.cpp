// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "simulation/player/TransitionShape.h"
#include "simulation/player/actions/LaneTransition.h"

namespace simulation
{

/// The acceleration sideways, offset · bend / duration², gives the duration.
std::unique_ptr<RunningAction> startAction(const LaneOffsetAction& action, ActionScene& scene, int actor)
{
    EntityMotion& motion = scene.motion(actor);
    if (!scene.roads() || !motion.state().place) return nullptr;
    const RoadPlace& place = *motion.state().place;
    double offset = action.offsetM;
    if (!action.entity.empty())
    {
        const int other = scene.find(action.entity);
        if (other < 0 || !scene.motion(other).state().place) return nullptr;
        offset += scene.motion(other).state().place->laneOffsetM;
    }
    const bool mayMove = action.maxLateralAccelerationMps2 != 0.0; // else it stays where it is
    if (!mayMove) offset = place.laneOffsetM;
    const double bend = greatestBend(action.shape) * std::fabs(offset - place.laneOffsetM);
    const double most = std::fabs(action.maxLateralAccelerationMps2.value_or(0.0));
    const double duration = most > 0.0 ? std::sqrt(bend / most) : 0.0;
    return std::make_unique<LaneTransition>(
        LaneTransition::Course{place.lane, offset, action.shape, duration, false, action.isContinuous, false},
        motion, *scene.roads());
}

} // namespace simulation
