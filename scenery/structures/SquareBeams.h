// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>

#include "scenery/structures/Beams.h"
#include "scenery/structures/StructureFacets.h"

namespace scenery
{

/// Bodies in the squares of the plan that they stand in.
class SquareBeams
{
public:
    explicit SquareBeams(StructureSquares& squares) : _squares(squares) {}

    StructureSquare& at(const glm::dvec3& place)
    {
        const auto number = [](double m)
        { return static_cast<std::int64_t>(std::floor(m / kStructureSquareM)); };
        const auto [found, isNew] = _squares.try_emplace({number(place.x), number(place.y)});
        if (isNew) found->second.origin = place;
        return found->second;
    }

    static Beams in(StructureSquare& square, Facets StructureSquare::*part, const glm::vec3& colour)
    {
        Beams beams(square.*part, square.origin);
        beams.colour(colour);
        return beams;
    }

private:
    StructureSquares& _squares;
};

/// The direction to the left of a line at one of its points: across both stretches there. Units: 1.
inline glm::dvec2 leftAt(const std::vector<glm::dvec2>& line, std::size_t point)
{
    glm::dvec2 along(0.0);
    for (const std::size_t from : {point - 1, point})
        if (from < line.size() && from + 1 < line.size() && glm::distance(line[from], line[from + 1]) > 1e-6)
            along += glm::normalize(line[from + 1] - line[from]);
    const double length = glm::length(along);
    return length > 1e-6 ? glm::dvec2(-along.y, along.x) / length : glm::dvec2(0.0, 1.0);
}

} // namespace scenery
