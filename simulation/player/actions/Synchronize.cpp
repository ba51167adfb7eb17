// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

constexpr double kStandingMps = 1e-3;
constexpr double kSoonS = 1e-3;
constexpr double kPastM = 1e-3; ///< by which a way grows behind its end

/// Steers the speed so that the actor arrives when the master does. The master is expected to keep its speed;
/// while it stands, so does the actor. Acceleration: with the way d, the time T, the own speed v and the
/// final one w it is (4d/T − 3v − w)/T, that of a speed that is straight in two halves of the time, asked
/// anew in each step. Without a final speed: d/T is driven. Before a steady part d and T count to its begin;
/// on it the speed is the final one. Ways are those along trajectories, else along roads, else straight. It
/// ends with the final speed, where one of both is there, or has passed.
class Synchronize final : public RunningAction
{
public:
    Synchronize(const SynchronizeAction& action, int master, int actor)
        : _action(action), _master(master), _actor(actor)
    {
    }

    ActionDomain domain() const override { return ActionDomain::longitudinal; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const double masterMps = scene.motion(_master).state().speedMps;
        const auto masterWay = wayTo(scene, _master, _action.masterPosition);
        const auto way = wayTo(scene, _actor, _action.position);
        if (!masterWay || !way) return true;
        if (hasArrived(*masterWay, *way))
        {
            if (const auto last = finalSpeed(masterMps)) actor.setSpeed(*last, scene.timeS());
            return true;
        }
        if (std::fabs(masterMps) < kStandingMps)
        {
            actor.setSpeed(0.0, scene.timeS());
            return false;
        }
        const double time = std::max(*masterWay / std::fabs(masterMps), kSoonS);
        actor.setSpeed(std::max(speed(actor.state().speedMps, *way, time, masterMps, scene.stepS()), 0.0),
                       scene.timeS());
        return false;
    }

private:
    static std::optional<double> wayTo(ActionScene& scene, int entity, const Position& position)
    {
        const auto placed = scene.positions().place(position);
        if (!placed) return std::nullopt;
        const EntityMotion& motion = scene.motion(entity);
        if (const auto metres = motion.wayOnTrajectory(placed->position)) return metres;
        const EntityState& state = motion.state();
        if (scene.roads() && placed->place && state.place)
            if (const auto metres = distanceAlong(*scene.roads(), *state.place, *placed->place))
                return std::fabs(*metres);
        return glm::distance(placed->position, state.position);
    }

    bool hasArrived(double masterWay, double way)
    {
        const bool isPast = masterWay > _lastMasterWay + kPastM || way > _lastWay + kPastM;
        _lastMasterWay = masterWay;
        _lastWay = way;
        return isPast || masterWay < _action.masterToleranceM || way < _action.toleranceM;
    }

    std::optional<double> finalSpeed(double masterMps) const
    {
        if (const auto* absolute = std::get_if<AbsoluteTargetSpeed>(&_action.finalSpeed))
            return absolute->speedMps;
        if (const auto* relative = std::get_if<RelativeTargetSpeed>(&_action.finalSpeed))
            return relative->isFactor ? relative->value * masterMps : relative->value + masterMps;
        return std::nullopt;
    }

    double speed(double own, double way, double time, double masterMps, double stepS)
    {
        const auto last = finalSpeed(masterMps);
        if (!last) return way / time;
        const double steadyM = _action.steadyDistanceM.value_or(_action.steadyTimeS.value_or(0.0) * *last);
        if (steadyM > 0.0 && *last > 0.0)
        {
            way -= steadyM;
            time -= steadyM / *last;
            _isSteady = _isSteady || way <= 0.0 || time <= kSoonS;
        }
        if (_isSteady) return *last;
        return own + (4.0 * way / time - 3.0 * own - *last) / time * stepS;
    }

    SynchronizeAction _action;
    int _master, _actor;
    bool _isSteady = false;
    double _lastWay = std::numeric_limits<double>::infinity(), _lastMasterWay = _lastWay;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const SynchronizeAction& action, ActionScene& scene, int actor)
{
    const int master = scene.find(action.master);
    if (master < 0) return nullptr;
    auto running = std::make_unique<Synchronize>(action, master, actor);
    if (running->step(scene, scene.motion(actor))) return nullptr;
    return running;
}

} // namespace simulation
