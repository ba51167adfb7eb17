// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{
namespace
{

constexpr double kStandingMps = 1e-3;
constexpr double kSoonS = 1e-3;

/// Steers the speed so that the actor arrives when the master does. The master is expected to keep its speed; while it stands,
/// so does the actor. Acceleration: with the way d, the time T, the own speed v and the final one w it is (4d/T − 3v − w)/T, that of a
/// speed that is straight in two halves of the time, asked anew in each step. Without a final speed: d/T is driven.
class Synchronize final : public RunningAction
{
public:
    Synchronize(const SynchronizeAction& action, int master) : _action(action), _master(master) {}

    ActionDomain domain() const override { return ActionDomain::longitudinal; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const EntityState& master = scene.motion(_master).state();
        const auto masterWay = wayTo(scene, master, _action.masterPosition);
        const auto way = wayTo(scene, actor.state(), _action.position);
        if (!masterWay || !way) return true;
        if (*masterWay < _action.masterToleranceM || *way < _action.toleranceM) return true;
        if (std::fabs(master.speedMps) < kStandingMps)
        {
            actor.setSpeed(0.0, scene.timeS());
            return false;
        }
        const double time = std::max(*masterWay / std::fabs(master.speedMps), kSoonS);
        actor.setSpeed(std::max(speed(scene, actor.state().speedMps, *way, time, master.speedMps), 0.0),
                       scene.timeS());
        return false;
    }

private:
    static std::optional<double> wayTo(const ActionScene& scene, const EntityState& state,
                                       const Position& position)
    {
        const auto placed = scene.positions().place(position);
        if (!placed) return std::nullopt;
        if (scene.roads() && placed->place && state.place)
            if (const auto metres = distanceAlong(*scene.roads(), *state.place, *placed->place))
                return std::fabs(*metres);
        return glm::distance(placed->position, state.position);
    }

    double speed(const ActionScene& scene, double own, double way, double time, double masterMps) const
    {
        double last = 0.0;
        if (const auto* absolute = std::get_if<AbsoluteTargetSpeed>(&_action.finalSpeed))
            last = absolute->speedMps;
        else if (const auto* relative = std::get_if<RelativeTargetSpeed>(&_action.finalSpeed))
            last = relative->isFactor ? relative->value * masterMps : relative->value + masterMps;
        else
            return way / time;
        return own + (4.0 * way / time - 3.0 * own - last) / time * scene.stepS();
    }

    SynchronizeAction _action;
    int _master;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const SynchronizeAction& action, ActionScene& scene, int actor)
{
    const int master = scene.find(action.master);
    if (master < 0) return nullptr;
    auto running = std::make_unique<Synchronize>(action, master);
    if (running->step(scene, scene.motion(actor))) return nullptr;
    return running;
}

} // namespace simulation
