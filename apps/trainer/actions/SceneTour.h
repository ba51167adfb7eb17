// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <foundation/Result.h>

#include "request/PlayRequest.h"
#include "scene/SceneTerrain.h"
#include "simulation/tour/TourTerrain.h"

namespace trainer
{

/// A tour, and lines that say what it is, each with its end.
struct SceneTour
{
    simulation::Tour tour;
    std::string summary;
};

/// Makes the tour of `trainer tour` over the terrain that request.terrain names. With the eye of a driver, or
/// above a car, it is a drive along the roads, with a pilot's a flight; else a drive where the file is a road
/// network.
/// Errors: those of layTour() and layDriveAlong(); a drive without roads, or without a lane for cars.
foundation::Result<SceneTour> layTourFor(const SceneTerrain& terrain, const PlayRequest& request,
                                         double durationS);

} // namespace trainer
