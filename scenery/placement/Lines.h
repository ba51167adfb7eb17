// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "scenery/placement/Surroundings.h"

namespace scenery
{

/// Lines with widths, in cells, so that the nearest of many is found quickly.
class Lines
{
public:
    /// `reachM`: farther away nothing is looked for; above 0.
    explicit Lines(double reachM) : _reachM(reachM) {}

    void add(const Corridor& corridor);

    /// From a place to the nearest line's edge, below 0 within; `reachM` where nothing is nearer.
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

/// The line without places nearer than `stepM` to the one before; its ends stay.
std::vector<glm::dvec2> thinned(const std::vector<glm::dvec2>& line, double stepM);

} // namespace scenery
