// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenSCENARIO XML 1.2 and 1.3, AnimationAction.
#include <algorithm>
#include <cmath>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

/// Moves a part of an entity evenly to its state; one that repeats goes through its course again and again,
/// without an end.
class Animate final : public RunningAction
{
public:
    Animate(const AnimationAction& action, double from, double startS)
        : _action(action), _from(from), _startS(startS)
    {
    }

    ActionDomain domain() const override { return ActionDomain::looks; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const double duration = _action.durationS.value_or(0.0);
        double share = duration > 0.0 ? (scene.timeS() - _startS) / duration : 1.0;
        const bool isDone = !_action.isLoop && share >= 1.0 - 1e-9;
        share = _action.isLoop ? share - std::floor(share) : std::min(share, 1.0);
        if (isDone) share = 1.0;
        actor.setAnimation(_action.part, _from + share * (_action.state - _from));
        return isDone;
    }

private:
    AnimationAction _action;
    double _from;
    double _startS;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const AnimationAction& action, ActionScene& scene, int actor)
{
    const auto& animations = scene.motion(actor).state().animations;
    const auto found = animations.find(action.part);
    return std::make_unique<Animate>(action, found == animations.end() ? 0.0 : found->second, scene.timeS());
}

} // namespace simulation
