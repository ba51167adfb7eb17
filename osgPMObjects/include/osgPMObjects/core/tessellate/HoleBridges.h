// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/InsideLoops.h>

namespace osgPMObjects::core
{

/// Joins each hole to the contour around it by a bridge, an edge that is run through in both directions. Each
/// part of the inside becomes one loop. `loops`: as insideLoops() returns them.
/// Cost: for each hole, a pass over all edges and points.
/// Source: Jin, *Polygon Techniques*, "several contours into one"; Eberly, "Triangulation by ear clipping"
/// (2002), §3 (ray to the nearest edge, then the first point in the way). Differs: rays go to the left, holes
/// are joined from left to right, all comparisons are exact without computing the hit point, and visits of
/// the same point are told apart by their sectors.
std::vector<Loop> bridgeHoles(std::span<const glm::dvec2> points, std::span<const Loop> loops);

} // namespace osgPMObjects::core
