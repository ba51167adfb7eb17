// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string_view>

#include "simulation/player/controllers/EntityController.h"
#include "simulation/scenario/Entity.h"

namespace simulation
{

/// A controller of scenarios that sets the speed of its entity.
struct SpeedControllerMaker
{
    std::string_view name; ///< of its kind: see controllerKinds()

    /// `speedMps`: of the entity, when the controller is activated.
    std::unique_ptr<EntityController> (*make)(const Controller& controller, double speedMps);
};

std::unique_ptr<EntityController> makeAdaptiveCruise(const Controller& controller, double speedMps);
std::unique_ptr<EntityController> makeIntelligentDriver(const Controller& controller, double speedMps);
std::unique_ptr<EntityController> makeStandingStill(const Controller& controller, double speedMps);

/// All controllers that set a speed, a file for each beside this one.
inline constexpr SpeedControllerMaker kSpeedControllers[] = {
    {"ACCController", makeAdaptiveCruise},
    {"IntelligentDriver", makeIntelligentDriver},
    {"InteractiveController", makeStandingStill}, // while nobody sits there
};

/// Makes what plays a controller; null: it is no controller of the speed.
std::unique_ptr<EntityController> makeSpeedController(const Controller& controller, double speedMps);

} // namespace simulation
