// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "PlayRequest.h"
#include "SceneTerrain.h"
#include "scenery/nodes/SceneryNode.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/FrameStatistics.h"

namespace trainer
{

/// What stands on the terrain of a play.
struct SceneScenery
{
    scenery::SceneryNode node;
    std::vector<std::string> notes; ///< how many objects, what found no room, how long it took

    /// Of the frame that was drawn last.
    ObjectFigures figures(unsigned int frameNumber) const;
};

/// Reads, makes and places what the request asks for: --scenery FILE, and of --objects DIR every model that can be read, as one
/// field more, scattered beside the way. `scenario` and `options`: as they will be played. Nothing where nothing is asked for.
/// Errors: of the file, a folder without models, a model, a terrain whose ground cannot be asked.
foundation::Result<std::optional<SceneScenery>> makeScenery(const SceneryRequest& request, double playS,
                                                            const simulation::Scenario& scenario,
                                                            const simulation::PlayerOptions& options,
                                                            const SceneTerrain& terrain);

} // namespace trainer
