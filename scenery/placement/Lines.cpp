// SPDX-License-Identifier: Apache-2.0
#include "scenery/placement/Lines.h"

#include <algorithm>
#include <cmath>

#include <foundation/NearestOnSegment.h>
#include <glm/glm.hpp>

namespace scenery
{

namespace
{

double distanceToPiece(glm::dvec2 place, glm::dvec2 from, glm::dvec2 to)
{
    return glm::length(place - from - foundation::nearestShare(place, from, to) * (to - from));
}

} // namespace

std::int64_t Lines::cellOf(double metres) const
{
    return static_cast<std::int64_t>(std::floor(metres / _reachM));
}

std::uint64_t Lines::keyOf(std::int64_t column, std::int64_t row)
{
    return (static_cast<std::uint64_t>(column) << 32U) ^ (static_cast<std::uint64_t>(row) & 0xffffffffU);
}

/// A piece lies in every cell that its box and the reach about it touch, so that one cell is enough to be
/// asked.
void Lines::add(const Corridor& corridor)
{
    for (std::size_t i = 0; i < corridor.line.size(); ++i)
    {
        if (i + 1 == corridor.line.size() && i > 0) break;
        const glm::dvec2 from = corridor.line[i],
                         to = corridor.line[std::min(i + 1, corridor.line.size() - 1)];
        const auto number = static_cast<std::uint32_t>(_pieces.size());
        _pieces.push_back({from, to, corridor.halfWidthM});
        const glm::dvec2 reach(corridor.halfWidthM + _reachM);
        const glm::dvec2 low = glm::min(from, to) - reach, high = glm::max(from, to) + reach;
        for (auto row = cellOf(low.y); row <= cellOf(high.y); ++row)
            for (auto column = cellOf(low.x); column <= cellOf(high.x); ++column)
                _cells[keyOf(column, row)].push_back(number);
    }
}

double Lines::distanceM(glm::dvec2 place) const
{
    double least = _reachM;
    const auto found = _cells.find(keyOf(cellOf(place.x), cellOf(place.y)));
    if (found == _cells.end()) return least;
    for (const std::uint32_t number : found->second)
    {
        const Piece& piece = _pieces[number];
        least = std::min(least, distanceToPiece(place, piece.from, piece.to) - piece.halfWidthM);
    }
    return least;
}

std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line, double stepM)
{
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < line.size(); ++i)
        if (kept.empty() || i + 1 == line.size() || glm::length(line[i] - kept.back()) >= stepM)
            kept.push_back(line[i]);
    return kept;
}

} // namespace scenery
