// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>

#include <foundation/Result.h>

#include "request/PlayRequest.h"
#include "simulation/track/FlightTrack.h"

namespace trainer
{

struct HeadlessRequest;

/// How a recording is played.
struct TrackRequest
{
    double startS = 0.0;            ///< how far into it
    std::filesystem::path saveFile; ///< for the scenario that is made of it; empty: not written
    std::optional<simulation::HeightDatum> datum{}; ///< what all heights count from; absent: as the file says
};

/// Plays a recorded track (`request.scenario`) over the terrain of the request, or over flat ground where it
/// names none: every object of it is an entity. Prints what was passed over in the file and what was done to
/// its heights. Errors: as readTracks(), scenarioOf() and makeFlatScene(); a terrain without a place on
/// earth.
foundation::Outcome playTracks(const PlayRequest& request, const TrackRequest& tracks);

/// Plays it without pictures, over the terrain of the request, or where it names none without ground: then
/// the origin lies at sea level below the first fix. Errors: as playTracks() and playOut().
foundation::Outcome playTracksHeadless(const PlayRequest& request, const TrackRequest& tracks,
                                       const HeadlessRequest& headless);

} // namespace trainer
