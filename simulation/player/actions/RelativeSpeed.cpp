// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

double targetOf(const RelativeTargetSpeed& target, double otherMps)
{
    return target.isFactor ? target.value * otherMps : target.value + otherMps;
}

/// Follows the speed of another entity: through the transition first, then as it changes.
class FollowSpeed final : public RunningAction
{
public:
    FollowSpeed(const RelativeTargetSpeed& target, int other, double readyAtS)
        : _target(target), _other(other), _readyAtS(readyAtS)
    {
    }

    ActionDomain domain() const override { return ActionDomain::longitudinal; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        if (scene.timeS() < _readyAtS) return false;
        actor.setSpeed(targetOf(_target, scene.motion(_other).state().speedMps), scene.timeS());
        return false;
    }

private:
    RelativeTargetSpeed _target;
    int _other;
    double _readyAtS;
};

} // namespace

/// Starts the change to the speed that the other has now; a continuous target is followed after it.
std::unique_ptr<RunningAction> startAction(const SpeedAction& action, ActionScene& scene, int actor)
{
    const auto* relative = std::get_if<RelativeTargetSpeed>(&action.target);
    const int other = relative ? scene.find(relative->entity) : -1;
    if (other < 0) return nullptr;
    const double target = targetOf(*relative, scene.motion(other).state().speedMps);
    EntityMotion& motion = scene.motion(actor);
    const SpeedProfile change(motion.state().speedMps, target, action.dynamics);
    motion.startSpeed({action.source, action.dynamics, AbsoluteTargetSpeed{target}}, scene.timeS());
    return std::make_unique<FollowSpeed>(*relative, other, scene.timeS() + change.durationS());
}

} // namespace simulation
