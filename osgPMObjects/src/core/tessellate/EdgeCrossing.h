// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

#include "EdgeContacts.h"

namespace osgPMObjects::core
{

glm::dvec2 onGrid(const glm::dvec2& point, double grid);

/// Returns the crossing point of two edges that cross, rounded to a grid; for nearly parallel edges a point
/// in the overlap of their boxes.
glm::dvec2 crossingOf(std::span<const glm::dvec2> points, const EdgeEnds& first, const EdgeEnds& second,
                      double grid);

/// Expresses a position on two edges of contours by the corners at their ends.
InsertedPoint betweenCorners(std::span<const glm::dvec2> corners, const std::array<EdgeEnds, 2>& edges,
                             const glm::dvec2& position);

} // namespace osgPMObjects::core
