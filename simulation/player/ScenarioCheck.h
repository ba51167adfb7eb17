// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/player/MotionSource.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Checks that a scenario can be played in a scene: every position can be located, every trajectory can be run, every
/// reference to an entity or a storyboard element is valid. Unsupported content is skipped.
/// Errors: the first fault, as `name:line`.
/// `roads`: of the LogicFile; null: none.
foundation::Outcome checkPlayable(const Scenario& scenario, const SceneFrame& frame, const std::string& name,
                                  const RoadScene* roads = nullptr);

/// Checks the controllers of all entities, and those that actions assign, before the play. Errors: of MotionSource::check(), with the
/// line of the controller.
foundation::Outcome checkControllers(const Scenario& scenario, MotionSource& source, const std::string& name);

} // namespace simulation
