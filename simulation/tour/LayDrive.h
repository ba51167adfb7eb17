// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

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

/// A place on a way, and the speed that is allowed there.
struct WayPoint
{
    glm::dvec3 place{0.0};
    double limitMps = 1e9;
};

/// Makes a drive over open ground: a car follows gentleTrack() from one point towards another and slows down
/// in bends (2 m/s² sideways, 1.5 m/s² along). The vertices have no heights: the player puts the car on its
/// ground. The scenario has one entity, `car`, on a trajectory with times in mode `follow`.
/// Errors: points outside the extent or closer than 20 m to each other; a duration below 1 s.
foundation::Result<Tour> layDrive(const TourTerrain& terrain, const DriveOptions& options);

/// Makes a drive along a way that is known, at the speeds that it allows, slower in bends (as layDrive()). It
/// begins in motion, 16 m after the way's begin (1 m and a tenth of a way shorter than 150 m), beyond the
/// worn end of a road; where the way ends before the time it stops 20 m before the end. The vertices have the
/// heights of the way, so that under a bridge the car is on the road below.
/// `way`: points at most some metres apart. Errors: a way shorter than 20 m; a duration below 1 s.
foundation::Result<Tour> layDriveAlong(const TourTerrain& terrain, std::vector<WayPoint> way,
                                       double durationS);

} // namespace simulation
