// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include "simulation/tour/TourTerrain.h"

namespace simulation
{

struct DriveOptions
{
    glm::dvec2 fromM{0.0}; ///< east, north in the scene's frame
    glm::dvec2 toM{0.0};
    double durationS = 14.0; ///< the drive ends then, at the destination or not
    double startSpeedMps = 8.0;
    double largestSpeedMps = 16.0;
};

/// Makes a drive over open ground: a car follows gentleTrack() from one point towards another and slows down in bends
/// (2 m/s² sideways, 1.5 m/s² along). The vertices have no heights: the player puts the car on its ground.
/// The scenario has one entity, `car`, on a trajectory with times in mode `follow`.
/// Errors: points outside the extent or closer than 20 m to each other; a duration below 1 s.
foundation::Result<Tour> layDrive(const TourTerrain& terrain, const DriveOptions& options);

} // namespace simulation
