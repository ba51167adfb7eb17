// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "SceneTerrain.h"
#include "request/PlayRequest.h"
#include "scenery/nodes/SceneryNode.h"
#include "simulation/player/ScenarioPlayer.h"
#include "view/FrameStatistics.h"

namespace trainer
{

/// The objects on the terrain of a play.
struct SceneScenery
{
    scenery::SceneryNode node;
    osgPMObjects::core::SceneBudgetSettings fullBudget; ///< of the scenery file
    scenery::SkyOccluders occluders;                    ///< what of it hides the sky from the ground
    std::vector<std::string> notes;                     ///< number of objects, fields without room, time

    /// Returns the figures of the frame drawn last.
    ObjectFigures figures(unsigned int frameNumber) const;
};

/// Reads what the request names, and nothing that this names. Errors: of the file, a folder without models.
foundation::Outcome checkScenery(const SceneryRequest& request);

/// Reads, makes and places the objects of the request: its scenery file, and all readable models of its
/// folder as one more field, scattered beside the paths. `playS`: seconds that are played, 0 to the end of
/// the scenario;
/// `scenario`, `options`: as they will be played. Returns nothing when the request is empty.
/// Errors: of the file, a folder without models, a model, a terrain without ground queries.
foundation::Result<std::optional<SceneScenery>> makeScenery(const SceneryRequest& request, double playS,
                                                            const simulation::Scenario& scenario,
                                                            const simulation::PlayerOptions& options,
                                                            const SceneTerrain& terrain);

} // namespace trainer
