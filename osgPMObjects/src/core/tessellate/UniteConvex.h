// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osgPMObjects/core/tessellate/InsideLoops.h>

namespace osgPMObjects::core
{

/// Unites convex pieces like uniteConvex(), which does it for triangles.
std::vector<Loop> uniteConvexPieces(std::span<const glm::dvec2> points, std::span<const Loop> pieces);

/// Tells whether the path a→b→c turns left or goes straight on.
bool turnsLeftOrStraight(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

} // namespace osgPMObjects::core
