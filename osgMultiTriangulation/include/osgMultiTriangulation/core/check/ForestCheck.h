// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/structure/Forest.h>

namespace osgMultiTriangulation::core
{

/// What a flight over a forest came to.
struct ForestFlight
{
    int frames = 0, checkedFrames = 0; ///< of the latter, every point was measured
    std::size_t mostTriangles = 0;
    double worstExcessM = 0.0; ///< of a point beyond what its triangle promises; rounding is below 1e-6
    std::optional<std::string>
        fault; ///< the first frame that was no triangulation of the surface, or broke a bound
};

/// Returns the points of the surface, each once.
std::vector<SurfacePoint> pointsOf(const Forest& forest);

/// Flies an eye over the surface in a straight line from corner to corner, with more detail near it, and
/// checks each frame: that it is a triangulation of the surface, and in every tenth frame, by brute force,
/// that each point keeps its bound.
/// Tolerance: a share of the distance that runs from coarse to fine over the flight.
ForestFlight flyOver(const Forest& forest, int frames);

} // namespace osgMultiTriangulation::core
