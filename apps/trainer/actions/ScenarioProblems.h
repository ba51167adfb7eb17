// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/track/LayRecordings.h"

namespace trainer
{

/// Tells on stderr what a scenario has that is not in effect: a line for each kind, with the first place and
/// how many more there are. Errors: the first thing that is wrong.
foundation::Outcome tellProblems(const std::vector<simulation::Problem>& problems);

/// Reads the recorded tracks that a scenario names, and tells what was done to them. Errors: as
/// simulation::layRecordings().
foundation::Outcome tellRecordings(simulation::Scenario& scenario, const simulation::RecordingPlace& place);

/// Tells what a scenario refers to that is not there.
void tellWarnings(const simulation::ScenarioPlayer& player);

} // namespace trainer
