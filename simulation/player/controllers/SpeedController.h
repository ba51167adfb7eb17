// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "simulation/player/actions/RunningAction.h"

namespace simulation
{

/// Drives an entity in place of the actions on its speed, once it is activated.
class SpeedController
{
public:
    virtual ~SpeedController() = default;

    /// Returns the speed after the step. Entities without a controller have moved already.
    virtual double speedAfter(ActionScene& scene, int actor) = 0;

    /// Goes on from this speed, after somebody else had the entity.
    virtual void resume(double /*speedMps*/) {}

    /// Hears the speed that an action asks for.
    virtual void askFor(double speedMps) = 0;
};

/// Makes what plays a controller; null: it is the default one, or is not played.
std::unique_ptr<SpeedController> makeSpeedController(const Controller& controller, const EntityState& state);

std::unique_ptr<SpeedController> makeAdaptiveCruise(const Controller& controller, double speedMps);
std::unique_ptr<SpeedController> makeIntelligentDriver(const Controller& controller, double speedMps);

/// The limits of an entity; of one without, those of a car.
Performance performanceOf(const ScenarioObject& object);

} // namespace simulation
