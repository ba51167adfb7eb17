// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/actions/RunningAction.h"
#include "simulation/player/actions/SpeedCourse.h"

namespace simulation
{
namespace
{

class SpeedProfileRun final : public RunningAction
{
public:
    SpeedProfileRun(SpeedCourse course, double startS) : _course(std::move(course)), _startS(startS) {}

    ActionDomain domain() const override { return ActionDomain::longitudinal; }

    bool step(ActionScene& scene, EntityMotion& actor) override
    {
        const double time = scene.timeS() - _startS;
        actor.setSpeed(_course.speedAt(time), scene.timeS());
        return time >= _course.durationS() - 1e-9;
    }

private:
    SpeedCourse _course;
    double _startS;
};

} // namespace

std::unique_ptr<RunningAction> startAction(const SpeedProfileAction& action, ActionScene& scene, int actor)
{
    const auto* vehicle =
        std::get_if<Vehicle>(&scene.scenario().entities[static_cast<std::size_t>(actor)].object);
    const Performance performance = vehicle ? vehicle->performance : Performance{};
    EntityMotion& motion = scene.motion(actor);
    motion.setSpeed(motion.state().speedMps, scene.timeS());
    return std::make_unique<SpeedProfileRun>(SpeedCourse(action, motion.state().speedMps,
                                                         performance.maxAccelerationMps2,
                                                         performance.maxDecelerationMps2),
                                             scene.timeS());
}

} // namespace simulation
