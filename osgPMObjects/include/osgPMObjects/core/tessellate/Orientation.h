// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// On which side of the line a→b the point c lies: positive left, negative right, zero on it. The sign is exact, the
/// value is not. Coordinates: zero, or of magnitude 2^-200 to 2^200, so that no product under- or overflows.
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates" (1997), §4.2 for
/// the bound of the quick test; where that cannot tell, all six products are added up exactly, in one stage instead of his
/// three.
double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Whether the way from `corner` to `target` begins strictly inside the sector that a polygon with its inside on the left has
/// at `corner`, between the edges from `before` and to `behind`. These must not have the same direction. Exact.
bool isInSector(const glm::dvec2& before, const glm::dvec2& corner, const glm::dvec2& behind,
                const glm::dvec2& target);

} // namespace osgPMObjects::core
