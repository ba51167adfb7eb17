// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "simulation/player/CubicSpline.h"
#include "simulation/player/PathVertex.h"

namespace simulation
{

// Angles along a path as splines over its parameter, unwrapped, in radians. Where nothing can be said: nothing.

/// Through one angle of every vertex; nothing where a vertex leaves it out.
std::optional<CubicSpline> vertexAngles(const std::vector<PathVertex>& vertices,
                                        std::optional<double> Orientation::*member, CubicSpline::Kind kind);

/// Headings that all vertices give: reached in the middle of the segment that the vertex begins, the last at the end.
/// Source: what esmini 3.6 does with them in mode `position` (tests/core/sim/RealScenarioTest.cpp).
std::optional<CubicSpline> givenHeadings(const std::vector<PathVertex>& vertices);

/// Headings of the segments, turning within 2 m (at most half a segment) before and after each corner.
/// Source: as above, for vertices without headings.
std::optional<CubicSpline> segmentHeadings(const std::vector<PathVertex>& vertices);

} // namespace simulation
