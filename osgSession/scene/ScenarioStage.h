// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "SceneTerrain.h"
#include "request/PlayRequest.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Opens what a scenario is played on: the request's terrain, else the SceneGraphFile, else the LogicFile.
/// Where neither is there and `request.without` lets it be played, entities move over level ground at the
/// height of their start, which a note of the scene says.
/// Errors: as openScene() and simulation::missingFiles(); a SceneGraphFile that is not there, and no
/// LogicFile named.
foundation::Result<SceneTerrain> openStage(const simulation::Scenario& scenario, const PlayRequest& request);

} // namespace trainer
