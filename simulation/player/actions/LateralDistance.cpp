// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

constexpr double kThereM = 1e-6;

/// Keeps a distance sideways to another entity, as measured across the road: at once, or no faster than is
/// allowed.
class KeepLateralDistance final : public RunningAction
{
public:
    KeepLateralDistance(const LateralDistanceAction& action, int actor, int other)
        : _action(action), _actor(actor), _other(other)
    {
    }

    ActionDomain domain() const override { return ActionDomain::lateral; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const EntityState& other = scene.motion(_other).state();
        if (!actor.state().place || !other.place) return true;
        const RoadPlace& place = *actor.state().place;
        const double otherLeft = looksForward(*other.place) ? 1.0 : -1.0; // t that is to its left
        double side = _action.side * otherLeft;
        if (_action.side == 0) side = place.t >= other.place->t ? 1.0 : -1.0;
        const double missing = other.place->t + side * wantedM(scene) - place.t;
        const double most = _action.maxSpeedMps ? *_action.maxSpeedMps * scene.stepS() : std::fabs(missing);
        const double move = std::clamp(missing, -most, most);
        const double speed = std::max(std::fabs(actor.state().speedMps), 1e-3);
        const double turn = _action.maxSpeedMps ? std::atan(move / (speed * scene.stepS())) : 0.0;
        actor.setLane(place.lane, place.laneOffsetM + move, turn);
        return !_action.isContinuous && std::fabs(missing - move) < kThereM;
    }

private:
    double wantedM(ActionScene& scene) const
    {
        if (!_action.measure.isFreespace) return _action.distanceM;
        const auto widthOf = [&](int entity)
        { return scene.scenario().entities[static_cast<std::size_t>(entity)].box().widthM; };
        return _action.distanceM + 0.5 * (widthOf(_actor) + widthOf(_other));
    }

    LateralDistanceAction _action;
    int _actor, _other;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const LateralDistanceAction& action, ActionScene& scene, int actor)
{
    const int other = scene.find(action.entity);
    if (other < 0 || !scene.roads()) return nullptr;
    return std::make_unique<KeepLateralDistance>(action, actor, other);
}

} // namespace simulation
