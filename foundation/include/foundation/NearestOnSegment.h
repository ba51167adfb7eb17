// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

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

} // namespace foundation
