// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// A closed box with its edges along the axes. `uvLow`, `uvHigh`: the part of the picture that each of its sides shows.
struct Box
{
    glm::dvec3 low, high;
    glm::vec2 uvLow{0.0F}, uvHigh{0.0F};
    float bottomLight = 0.6F; ///< of its lower corners
};
void addBox(ModelBuilder& builder, const Box& box);

/// A closed bar of one cross section from one place to another: `profile` counter-clockwise seen from the end, convex or
/// a strip of quads (point i faces point n - 1 - i), which is how its ends are closed. Even number of points.
/// `cornerAt(end, point, face)`: end 0 or 1, the number of the point, and of the side it is a corner of (the ends come last).
template<class PlaceAt>
void addPrism(ModelBuilder& builder, std::size_t points, const PlaceAt& cornerAt)
{
    for (std::size_t i = 0; i < points; ++i)
    {
        const std::size_t next = (i + 1) % points;
        builder.quad(cornerAt(0, i, i), cornerAt(0, next, i), cornerAt(1, next, i), cornerAt(1, i, i));
    }
    for (std::size_t i = 0; i + 1 < points / 2; ++i)
    {
        const std::array<std::size_t, 4> strip{i, i + 1, points - 2 - i, points - 1 - i};
        const auto at = [&](std::size_t end, std::size_t k) { return cornerAt(end, strip[k], points + end); };
        builder.quad(at(1, 0), at(1, 1), at(1, 2), at(1, 3));
        builder.quad(at(0, 3), at(0, 2), at(0, 1), at(0, 0));
    }
}

} // namespace scenery::models
