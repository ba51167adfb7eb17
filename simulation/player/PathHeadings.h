// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/player/CubicSpline.h"
#include "simulation/player/PathVertex.h"

namespace simulation
{

// Angles along a path as splines over its parameter, in radians without jumps of 2π. Empty when the vertices
// give no angle.

/// Makes the spline through one angle of every vertex; nothing when a vertex has none.
std::optional<CubicSpline> vertexAngles(const std::vector<PathVertex>& vertices,
                                        std::optional<double> Orientation::*member, CubicSpline::Kind kind);

/// Makes the spline of headings that all vertices give: each is reached in the middle of the segment that the
/// vertex begins, the last at the end.
/// Source: esmini 3.6 in mode `position` (tests/core/simulation/RealScenarioTest.cpp).
std::optional<CubicSpline> givenHeadings(const std::vector<PathVertex>& vertices);

/// Makes the spline of the headings of the segments, which turns within 2 m (at most half a segment) before
/// and after each corner.
/// Source: as above, for vertices without headings.
std::optional<CubicSpline> segmentHeadings(const std::vector<PathVertex>& vertices);

} // namespace simulation
