// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "scenery/models/mesh/ModelBuilder.h"

namespace scenery::models
{

/// Adds a closed box along the axes. `uvLow`, `uvHigh`: the part of the texture on each of its sides.
struct Box
{
    glm::dvec3 low, high;
    glm::vec2 uvLow{0.0F}, uvHigh{0.0F};
    float bottomLight = 0.6F; ///< of its lower corners
};
void addBox(ModelBuilder& builder, const Box& box);

/// Adds a closed bar of one cross section between two points. `profile`: counter-clockwise seen from the end,
/// an even number of points, convex or a strip of quads (point i faces point n - 1 - i), as its ends are
/// closed that way.
/// `cornerAt(end, point, face)`: end 0 or 1, the index of the point, and the side of the corner (the ends
/// come last).
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
