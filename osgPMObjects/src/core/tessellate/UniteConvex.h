// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <osgPMObjects/core/tessellate/InsideLoops.h>

namespace osgPMObjects::core
{

/// uniteConvex() for pieces that are convex already.
std::vector<Loop> uniteConvexPieces(std::span<const glm::dvec2> points, std::span<const Loop> pieces);

/// Whether the way a→b→c turns left or goes straight on; not back.
bool turnsLeftOrNot(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

} // namespace osgPMObjects::core
