// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// Whether a scenario can be played in a scene: every position has a place, every trajectory can be run, every
/// reference to an entity or a storyboard element has its object. Unsupported content is passed over.
/// Errors: the first that cannot, as `name:line`.
foundation::Outcome checkPlayable(const Scenario& scenario, const SceneFrame& frame, const std::string& name);

} // namespace simulation
