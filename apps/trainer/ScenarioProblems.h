// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

#include "simulation/parser/ParseScenario.h"

namespace trainer
{

/// Tells on stderr what a scenario has that is not in effect: a line for each kind, with the first place and how many more there
/// are. Errors: the first thing that is wrong.
foundation::Outcome tellProblems(const std::vector<simulation::Problem>& problems);

} // namespace trainer
