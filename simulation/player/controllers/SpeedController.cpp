// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/controllers/SpeedController.h"

namespace simulation
{

void SpeedController::move(ActionScene& scene, int actor)
{
    EntityMotion& own = scene.motion(actor);
    own.setSpeed(speedAfter(scene, actor), scene.timeS());
    own.advanceTo(scene.timeS(), scene.stepS());
}

Performance performanceOf(const ScenarioObject& object)
{
    const auto* vehicle = std::get_if<Vehicle>(&object.object);
    return vehicle ? vehicle->performance : Performance{50.0, 5.0, 10.0};
}

} // namespace simulation
