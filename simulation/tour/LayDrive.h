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
    double durationS = 14.0; ///< the drive ends by then, wherever it is
    double startSpeedMps = 8.0;
    double largestSpeedMps = 16.0;
};

/// A drive over open ground: a car on gentleTrack() from one place towards another, slower in bends (2 m/s² sideways,
/// 1.5 m/s² along). The vertices carry no heights: the car stands on whatever ground the player has.
/// The scenario has one entity, `car`, on a timed trajectory in mode `follow`.
/// Errors: places beyond the extent, or closer than 20 m to each other; a duration below 1 s.
foundation::Result<Tour> layDrive(const TourTerrain& terrain, const DriveOptions& options);

} // namespace simulation
