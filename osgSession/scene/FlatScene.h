// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgTerrainROAM/core/features/GroundFeature.h>

#include "SceneTerrain.h"
#include "simulation/geodesy/LocalFrame.h"
#include "simulation/track/FlightTrack.h"

namespace trainer
{

/// Makes flat ground below recorded tracks, at the height that one fix of fifty is below, with 20 km around
/// them: a stage for a recording whose terrain is not at hand. `painted`: onto it. Errors: tracks that are
/// more than 5 degrees apart, or beyond 80 degrees of latitude.
foundation::Result<SceneTerrain> makeFlatScene(const std::vector<simulation::FlightTrack>& tracks,
                                               std::vector<osgTerrainROAM::core::GroundFeature> painted = {});

/// Makes level ground, 40 km square, around a place at its height: a stage for what has no terrain. Errors:
/// as makeFlatScene().
foundation::Result<SceneTerrain>
makeLevelScene(const simulation::Geodetic& middle,
               std::vector<osgTerrainROAM::core::GroundFeature> painted = {});

} // namespace trainer
