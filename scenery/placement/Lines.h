// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scenery/placement/Surroundings.h"

namespace scenery
{

/// A set of lines with widths, in a grid of cells, that finds the nearest line quickly.
class Lines
{
public:
    /// `reachM`: the largest distance that is searched; above 0.
    explicit Lines(double reachM) : _reachM(reachM) {}

    void add(const Corridor& corridor);

    /// Returns the distance from a point to the edge of the nearest line, negative inside it; `reachM` when
    /// none is nearer.
    double distanceM(glm::dvec2 place) const;

private:
    struct Piece
    {
        glm::dvec2 from{0.0}, to{0.0};
        double halfWidthM = 0.0;
    };

    std::int64_t cellOf(double metres) const;
    static std::uint64_t keyOf(std::int64_t column, std::int64_t row);

    double _reachM;
    std::vector<Piece> _pieces;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> _cells;
};

/// Returns the line without the points that are nearer than `stepM` to the one before; both ends stay.
std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line, double stepM);

} // namespace scenery
