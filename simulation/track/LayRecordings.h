// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Scenario.h"

namespace simulation
{

/// How the recordings of a scenario are read.
struct RecordingPlace
{
    std::filesystem::path scenario; ///< its file: the recordings lie beside it, and errors name it
    const SceneFrame* frame =
        nullptr; ///< heights are fitted to its ground; null: they stay as they were recorded
};

/// Reads the recorded tracks that trajectories name, and makes their polylines: GeoPositions by the times of
/// the recording, counted from its start. Over the ground of a frame heights are fitted as in scenarioOf(),
/// those of entities on the ground left to it. Returns a line for each thing that the user should know.
/// Errors, with the line of the scenario: those of readTracks(), no such track in the file, one that does not
/// move, times that are asked for and not there.
foundation::Result<std::vector<std::string>> layRecordings(Scenario& scenario, const RecordingPlace& place);

} // namespace simulation
