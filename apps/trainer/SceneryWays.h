// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/placement/Surroundings.h"
#include "simulation/player/ScenarioPlayer.h"

namespace trainer
{

/// Where a scenario's entities pass, found by playing it once without drawing: nothing may stand in what they drive over (their width
/// and a margin, and room about their first and last places for an eye behind them), nor below what flies lower than any tree.
/// `longestS`: of the play. Nothing where the scenario cannot be played. Cost: that of its steps.
scenery::Ways waysOf(const simulation::Scenario& scenario, const simulation::PlayerOptions& options,
                     double longestS);

} // namespace trainer
