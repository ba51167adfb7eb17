// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/InsideLoops.h>

namespace osgPMObjects::core
{

/// Joins each hole to what surrounds it by an edge that is run through in both directions, so that one loop is left for
/// each part of the inside. `loops`: as insideLoops() returns them.
/// Cost: for each hole, a walk through all edges and points.
/// Source: paper 002, "several contours into one"; Eberly, "Triangulation by ear clipping" (2002), §3 (ray to the nearest
/// edge, then the first point in the way). Differs: to the left and from left to right, all comparisons exact without ever
/// computing where the ray hits, and points that are visited several times are told apart by their sectors.
std::vector<Loop> bridgeHoles(std::span<const glm::dvec2> points, std::span<const Loop> loops);

} // namespace osgPMObjects::core
