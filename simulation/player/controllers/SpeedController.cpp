// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/controllers/SpeedController.h"

namespace simulation
{
namespace
{

/// A person who is not there: the entity stands still.
class NobodyDrives final : public SpeedController
{
public:
    double speedAfter(ActionScene&, int) override { return 0.0; }
};

} // namespace

void SpeedController::move(ActionScene& scene, int actor)
{
    EntityMotion& own = scene.motion(actor);
    own.setSpeed(speedAfter(scene, actor), scene.timeS());
    own.advanceTo(scene.timeS(), scene.stepS());
}

std::unique_ptr<SpeedController> makeSpeedController(const Controller& controller, const EntityState& state)
{
    if (controller.isInteractive()) return std::make_unique<NobodyDrives>();
    if (controller.isAdaptiveCruise()) return makeAdaptiveCruise(controller, state.speedMps);
    if (controller.isIntelligentDriver()) return makeIntelligentDriver(controller, state.speedMps);
    return nullptr;
}

Performance performanceOf(const ScenarioObject& object)
{
    const auto* vehicle = std::get_if<Vehicle>(&object.object);
    return vehicle ? vehicle->performance : Performance{50.0, 5.0, 10.0};
}

} // namespace simulation
