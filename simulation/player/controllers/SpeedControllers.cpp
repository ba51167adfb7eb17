// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/controllers/SpeedControllers.h"

#include "simulation/scenario/ControllerKinds.h"

namespace simulation
{

std::unique_ptr<EntityController> makeSpeedController(const Controller& controller, double speedMps)
{
    const ControllerKind* const kind = controller.played();
    for (const SpeedControllerMaker& maker : kSpeedControllers)
        if (kind && maker.name == kind->name) return maker.make(controller, speedMps);
    return nullptr;
}

} // namespace simulation
