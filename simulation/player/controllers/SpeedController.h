// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/player/actions/RunningAction.h"
#include "simulation/player/controllers/EntityController.h"

namespace simulation
{

/// Sets the speed of an entity in place of the actions on it, once it is activated; where the entity goes,
/// its actions say.
class SpeedController : public EntityController
{
public:
    /// Returns the speed after the step. It sees the others where they are now.
    virtual double speedAfter(ActionScene& scene, int actor) = 0;

    void move(ActionScene& scene, int actor) final;
};

/// The limits of an entity; of one without, those of a car.
Performance performanceOf(const ScenarioObject& object);

} // namespace simulation
