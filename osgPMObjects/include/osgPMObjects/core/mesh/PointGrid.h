// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/mesh/HashIndex.h>

namespace osgPMObjects::core
{

/// A hashed grid of numbered points, for queries by box. Cells with the same bucket are visited together, and
/// a point may be visited twice; callers compare distances anyway.
/// Memory: 8 to 12 B a point. Threads: one that adds; any number that visit.
class PointGrid
{
public:
    PointGrid(double cellSize, std::size_t expected)
        : _perUnit(1.0 / cellSize), _first(std::bit_ceil(expected + 16), HashIndex::kNone)
    {
    }

    /// Adds a point; points are numbered in this order.
    void add(const glm::dvec3& point)
    {
        std::uint32_t& bucket = _first[bucketOf(cellOf(point))];
        _next.push_back(bucket);
        bucket = static_cast<std::uint32_t>(_next.size() - 1);
    }

    /// Calls `visit(number)` for every point in the box, and perhaps for others.
    template<class Visit>
    void visitBox(const glm::dvec3& low, const glm::dvec3& high, const Visit& visit) const
    {
        const Cell from = cellOf(low), to = cellOf(high);
        for (std::int64_t x = from.x; x <= to.x; ++x)
            for (std::int64_t y = from.y; y <= to.y; ++y)
                for (std::int64_t z = from.z; z <= to.z; ++z)
                    for (std::uint32_t i = _first[bucketOf({x, y, z})]; i != HashIndex::kNone; i = _next[i])
                        visit(i);
    }

private:
    static constexpr double kMost = 4.0e18; ///< below 2^62, so that counting on does not overflow

    struct Cell
    {
        std::int64_t x, y, z;
    };

    Cell cellOf(const glm::dvec3& p) const
    {
        // A mesh of one point, far from the origin, has a cell size of 0 and a cell number beyond integers.
        const auto cell = [this](double x)
        { return static_cast<std::int64_t>(std::clamp(std::floor(x * _perUnit), -kMost, kMost)); };
        return {cell(p.x), cell(p.y), cell(p.z)};
    }

    std::size_t bucketOf(const Cell& c) const
    {
        const std::uint64_t hash =
            stir(stir(stir(0, static_cast<std::uint64_t>(c.x)), static_cast<std::uint64_t>(c.y)),
                 static_cast<std::uint64_t>(c.z));
        return hash & (_first.size() - 1);
    }

    double _perUnit;
    std::vector<std::uint32_t> _first; ///< by bucket: its first point
    std::vector<std::uint32_t> _next;  ///< by point: the next in its bucket
};

} // namespace osgPMObjects::core
