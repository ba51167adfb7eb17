// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/road/RoadScene.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Opens the roads that the LogicFile of a scenario names; null: it names none. `folder`: of the scenario.
/// Errors: as RoadScene::open().
foundation::Result<std::shared_ptr<const RoadScene>> openRoads(const Scenario& scenario,
                                                               const std::filesystem::path& folder);

} // namespace simulation
