// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "play/PlayRequest.h"

namespace trainer
{

/// How a recording is played.
struct TrackRequest
{
    double startS = 0.0;            ///< how far into it
    std::filesystem::path saveFile; ///< for the scenario that is made of it; empty: not written
};

/// Plays a recorded track (`request.scenario`) over the terrain of the request, or over flat ground where it
/// names none: every object of it is an entity. Prints what was passed over in the file and what was done to
/// its heights. Errors: as readTracks(), scenarioOf() and makeFlatScene(); a terrain without a place on
/// earth.
foundation::Outcome playTracks(const PlayRequest& request, const TrackRequest& tracks);

} // namespace trainer
