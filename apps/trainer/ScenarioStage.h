// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include "PlayRequest.h"
#include "SceneTerrain.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Opens what a scenario is played on: the request's terrain, else the SceneGraphFile, else the LogicFile.
/// Where neither is there, as with storyboards whose town belongs to another program, entities move over
/// level ground at the height of their start, and a note says so.
/// Errors: as openScene(); a SceneGraphFile that is not there, and no LogicFile named.
foundation::Result<SceneTerrain> openStage(const simulation::Scenario& scenario, const PlayRequest& request);

} // namespace trainer
