// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "HeadlessCommand.h"
#include "request/PlayRequest.h"
#include "scene/SceneTerrain.h"
#include "simulation/scenario/Scenario.h"

namespace trainer
{

/// Plays request.scenario to its end and writes the frames, statistics and report of request.output.
foundation::Outcome play(const PlayRequest& request);

/// Plays a scenario with a person in it to its end without pictures, over the ground that pictures have, and
/// writes the log of `headless` and what the person did. Errors: as play().
foundation::Outcome playSeatHeadless(const PlayRequest& request, const HeadlessRequest& headless);

/// Plays a scenario that is there already over a terrain, as play() does.
foundation::Outcome playScene(SceneTerrain terrain, simulation::Scenario scenario,
                              const PlayRequest& request);

/// Makes a tour over request.terrain, writes it to `saveFile` unless that is empty, and plays it. Units:
/// seconds.
foundation::Outcome tour(const PlayRequest& request, const std::filesystem::path& saveFile, double durationS);

/// Plays a scenario over an opened terrain, and leaves the results of the request.
foundation::Outcome playOver(SceneTerrain terrain, simulation::Scenario scenario, const PlayRequest& request);

} // namespace trainer
