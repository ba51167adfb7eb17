// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// Tells on which side of the line a→b the point c lies: positive is left, negative right, zero on the line.
/// The sign is exact, the value is not. Coordinates must be zero or of magnitude 2^-200 to 2^200, so that no
/// product over- or underflows.
/// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates"
/// (1997), §4.2, for the error bound of the quick test. Differs: if that test fails, all six products are
/// summed exactly in one stage, not three.
double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Tells whether the direction from `corner` to `target` lies strictly inside a polygon's sector at `corner`:
/// between the edges from `before` and to `behind`, the inside on the left. The two edges must have different
/// directions. Exact.
bool isInSector(const glm::dvec2& before, const glm::dvec2& corner, const glm::dvec2& behind,
                const glm::dvec2& target);

} // namespace osgPMObjects::core
