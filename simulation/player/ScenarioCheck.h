// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/player/MotionSource.h"
#include "simulation/player/SceneFrame.h"
#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Checks that a scenario can be played in a scene: every position can be located, every trajectory can be
/// run, every reference to an entity is valid, and Init puts entities on roads and lanes that there are.
/// Unsupported content is skipped. Returns what else refers to a road, a lane or a storyboard element that is
/// not there. Errors: the first fault. Both as `name:line`.
/// `roads`: of the LogicFile; null: none.
foundation::Result<std::vector<foundation::Error>> checkPlayable(const Scenario& scenario,
                                                                 const SceneFrame& frame,
                                                                 const std::string& name,
                                                                 const RoadScene* roads = nullptr);

/// Checks the controllers of all entities, and those that actions assign, before the play. Errors: of
/// MotionSource::check(), with the line of the controller.
foundation::Outcome checkControllers(const Scenario& scenario, MotionSource& source, const std::string& name);

} // namespace simulation
