// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

namespace foundation
{

/// Returns the share of the way from `a` to `b`, 0 to 1, at which the segment is nearest to a point; 0 where
/// both ends are one place.
/// Shapes: vectors of one length, in one frame and unit.
template<glm::length_t length, typename Number>
Number nearestShare(const glm::vec<length, Number>& point, const glm::vec<length, Number>& a,
                    const glm::vec<length, Number>& b)
{
    const glm::vec<length, Number> way = b - a;
    const Number square = glm::dot(way, way);
    return square > Number(0) ? std::clamp(glm::dot(point - a, way) / square, Number(0), Number(1))
                              : Number(0);
}

/// Returns the place of the segment from `a` to `b` that is nearest to a point.
/// Shapes: as nearestShare().
template<glm::length_t length, typename Number>
glm::vec<length, Number> nearestOnSegment(const glm::vec<length, Number>& point,
                                          const glm::vec<length, Number>& a,
                                          const glm::vec<length, Number>& b)
{
    return a + nearestShare(point, a, b) * (b - a);
}

/// Returns how far a point is from a line of points; infinite where there are fewer than two.
/// Shapes: as nearestShare().
template<glm::length_t length, typename Number>
Number distanceToLine(const glm::vec<length, Number>& point,
                      const std::vector<glm::vec<length, Number>>& line)
{
    Number least = std::numeric_limits<Number>::infinity();
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
        least = std::min(least, glm::distance(point, nearestOnSegment(point, line[i], line[i + 1])));
    return least;
}

} // namespace foundation
