// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

constexpr double kReachedM = 0.1;
constexpr double kSpringPerM = 0.4; ///< of the greatest acceleration
constexpr double kNoRateLimit = 1e9;

/// Keeps the distance to the other entity along the road: at once without limits, else with the accelerations
/// that are allowed.
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
        if (_action.side == 0) _action.side = *ahead >= 0.0 ? 1 : -1; // from now on
        const double excess = *ahead - _action.side * wantedM(scene, lead);
        if (_action.isLimited) return follow(scene, actor, lead, excess);
        RoadPlace place = *actor.state().place;
        walk(*scene.roads(), place, excess, {});
        actor.setPlace(place);
        actor.setSpeed(lead.speedMps, scene.timeS());
        return !_action.isContinuous;
    }

private:
    /// A time gap is the way of the other entity in that time, as in esmini.
    double wantedM(ActionScene& scene, const EntityState& lead) const
    {
        double wanted = _action.distanceM.value_or(_action.timeGapS.value_or(0.0) * std::fabs(lead.speedMps));
        if (!_action.measure.isFreespace) return wanted;
        const BoundingBox& own = scene.scenario().entities[static_cast<std::size_t>(_actor)].box();
        const BoundingBox& other = scene.scenario().entities[static_cast<std::size_t>(_other)].box();
        wanted += 0.5 * (own.lengthM + other.lengthM);
        return wanted + (_action.side < 0 ? other.centre.x - own.centre.x : own.centre.x - other.centre.x);
    }

    /// A critically damped spring between the entities, within the limits, as in esmini; the standard leaves
    /// the law open.
    bool follow(ActionScene& scene, EntityMotion& actor, const EntityState& lead, double excess)
    {
        const Performance performance = performanceOf(scene);
        const DynamicConstraints& limits = _action.constraints;
        const double faster = limits.maxAccelerationMps2.value_or(performance.maxAccelerationMps2);
        const double slower = limits.maxDecelerationMps2.value_or(performance.maxDecelerationMps2);
        const double most = limits.maxSpeedMps.value_or(performance.maxSpeedMps);
        const double spring = kSpringPerM * (excess < 0.0 ? faster : slower);
        const double now = actor.state().speedMps;
        const double pull = excess * spring - (now - lead.speedMps) * 2.0 * std::sqrt(spring);
        const double wanted = std::clamp(pull, -slower, faster);
        const double down = limits.maxDecelerationRateMps3.value_or(kNoRateLimit) * scene.stepS();
        const double up = limits.maxAccelerationRateMps3.value_or(kNoRateLimit) * scene.stepS();
        if (wanted < 0.0) _accelerationMps2 = std::max(wanted, _accelerationMps2 - down);
        if (wanted >= 0.0) _accelerationMps2 = std::min(wanted, _accelerationMps2 + up);
        const double bound = most > 0.0 ? most : kNoRateLimit;
        actor.setSpeed(std::clamp(now + _accelerationMps2 * scene.stepS(), -bound, bound), scene.timeS());
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
    double _accelerationMps2 = 0.0;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const LongitudinalDistanceAction& action, ActionScene& scene,
                                           int actor)
{
    const int other = scene.find(action.entity);
    if (other < 0) return nullptr;
    auto running = std::make_unique<KeepDistance>(action, actor, other);
    // What is there at once is there now; a limited one begins with the next step.
    if (!action.isLimited && running->step(scene, scene.motion(actor))) return nullptr;
    return running;
}

} // namespace simulation
