// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <foundation/Result.h>

#include "simulation/player/SceneFrame.h"
#include "simulation/scenario/Scenario.h"
#include "simulation/track/FlightTrack.h"

namespace simulation
{

struct TrackScenarioOptions
{
    std::string sceneFile;     ///< the terrain that the scenario names
    std::string description;   ///< of the scenario
    double startS = 0.0;       ///< how far into the recording the scenario begins
    bool isMadeGround = false; ///< heights are not fitted to it, only kept above it
};

/// A scenario of recorded tracks, and one line for each thing that the user should know.
struct TrackScenario
{
    Scenario scenario;
    std::vector<std::string> notes;
    double durationS = 0.0; ///< from the start of the scenario to the end of the last track
};

/// Makes a scenario in which each track is an entity that moves as it was recorded, over the ground of
/// `frame`, or where it has none without ground, at the heights that were recorded: heights count from the
/// ellipsoid (TrackGeoid.h), are fitted to the ground (TrackHeights.h, TrackClearance.h), those of vehicles
/// and persons left to it. What comes later or goes earlier is added and deleted by events. First stand those
/// that fly, then those that move, then the others; a track without times is followed at a usual speed. Sun
/// and hour are those of the recording, where it has a date.
/// Errors: no track touches the terrain; the recording ends before `startS`; nothing in it can be shown.
foundation::Result<TrackScenario> scenarioOf(std::vector<FlightTrack> tracks, const SceneFrame& frame,
                                             const TrackScenarioOptions& options);

} // namespace simulation
