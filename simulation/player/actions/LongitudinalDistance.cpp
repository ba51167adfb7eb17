// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

constexpr double kReachedM = 0.01;

/// Keeps the distance to the other entity along the road: at once without limits, else with the accelerations that are
/// allowed.
class KeepDistance final : public RunningAction
{
public:
    KeepDistance(const LongitudinalDistanceAction& action, int actor, int other)
        : _action(action), _actor(actor), _other(other)
    {
    }

    ActionDomain domain() const override { return ActionDomain::longitudinal; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const EntityState& lead = scene.motion(_other).state();
        if (!scene.roads() || !lead.place || !actor.state().place) return true;
        const auto ahead = distanceAlong(*scene.roads(), *actor.state().place, *lead.place);
        if (!ahead) return !_action.isContinuous;
        const double side = _action.side != 0 ? _action.side : (*ahead >= 0.0 ? 1.0 : -1.0);
        const double excess = *ahead - side * wantedM(scene, actor, lead);
        if (_action.isLimited) return follow(scene, actor, lead, excess);
        RoadPlace place = *actor.state().place;
        walk(*scene.roads(), place, excess, {});
        actor.setPlace(place);
        actor.setSpeed(lead.speedMps, scene.timeS());
        return !_action.isContinuous;
    }

private:
    double wantedM(ActionScene& scene, const EntityMotion& actor, const EntityState&) const
    {
        double wanted = _action.distanceM.value_or(_action.timeGapS.value_or(0.0) * actor.state().speedMps);
        if (!_action.measure.isFreespace) return wanted;
        const BoundingBox& own = scene.scenario().entities[static_cast<std::size_t>(_actor)].box();
        const BoundingBox& other = scene.scenario().entities[static_cast<std::size_t>(_other)].box();
        wanted += 0.5 * (own.lengthM + other.lengthM);
        return wanted + (_action.side < 0 ? other.centre.x - own.centre.x : own.centre.x - other.centre.x);
    }

    /// The speed from which the gap closes at the braking that is allowed, within the limits.
    bool follow(ActionScene& scene, EntityMotion& actor, const EntityState& lead, double excess) const
    {
        const Performance performance = performanceOf(scene);
        const double faster =
            _action.constraints.maxAccelerationMps2.value_or(performance.maxAccelerationMps2);
        const double slower =
            _action.constraints.maxDecelerationMps2.value_or(performance.maxDecelerationMps2);
        const double most = _action.constraints.maxSpeedMps.value_or(performance.maxSpeedMps);
        const double closing =
            excess >= 0.0 ? std::sqrt(2.0 * slower * excess) : -std::sqrt(-2.0 * faster * excess);
        const double wanted = std::clamp(lead.speedMps + closing, 0.0, most > 0.0 ? most : 1e3);
        const double now = actor.state().speedMps;
        actor.setSpeed(std::clamp(wanted, now - slower * scene.stepS(), now + faster * scene.stepS()),
                       scene.timeS());
        return !_action.isContinuous && std::fabs(excess) < kReachedM;
    }

    Performance performanceOf(ActionScene& scene) const
    {
        const auto& object = scene.scenario().entities[static_cast<std::size_t>(_actor)].object;
        const auto* vehicle = std::get_if<Vehicle>(&object);
        return vehicle ? vehicle->performance : Performance{50.0, 5.0, 10.0};
    }

    LongitudinalDistanceAction _action;
    int _actor, _other;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const LongitudinalDistanceAction& action, ActionScene& scene,
                                           int actor)
{
    const int other = scene.find(action.entity);
    if (other < 0) return nullptr;
    auto running = std::make_unique<KeepDistance>(action, actor, other);
    const bool isDone = running->step(scene, scene.motion(actor));
    if (isDone) return nullptr;
    return running;
}

} // namespace simulation
