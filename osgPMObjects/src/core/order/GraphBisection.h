// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgPMObjects::core
{

/// Halves sets of triangles with few neighbours in different halves.
/// Memory: 17 B a triangle of the mesh. Cost: linear in the set.
class GraphBisection
{
public:
    explicit GraphBisection(const TriangleAdjacency& adjacency);

    /// Puts one half before the other, and returns how many the first has: half of them, give or take one of 16.
    /// No triangle may be in two sets that are halved at a time, and a half may be halved again.
    std::size_t halve(std::span<std::uint32_t> triangles);

private:
    struct Move
    {
        std::uint32_t triangle;
        int cut; ///< how many edges are cut after it
    };

    std::uint32_t search(std::span<std::uint32_t> triangles, std::uint32_t first);
    void mend(std::span<const std::uint32_t> triangles, std::size_t target);
    bool improve(std::span<const std::uint32_t> triangles, std::size_t slack);
    int gain(std::uint32_t triangle) const;
    void offer(std::uint32_t triangle);
    std::uint32_t bestMove(std::size_t slack);

    const TriangleAdjacency& _adjacency;
    std::vector<std::uint32_t> _set;          ///< by triangle: the set that it was last in
    std::vector<std::uint32_t> _seen;         ///< by triangle: the search that saw it last
    std::vector<std::uint32_t> _moved;        ///< by triangle: the pass that moved it last
    std::vector<char> _isSecond;              ///< by triangle: which half
    std::vector<std::uint32_t> _found;        ///< by the search, in its order
    std::vector<std::uint32_t> _offers[2][7]; ///< by half and gain + 3: triangles that could change sides
    std::uint32_t _sets = 0, _searches = 0, _passes = 0;
    std::ptrdiff_t _excess = 0; ///< how many triangles the first half has too many
};

} // namespace osgPMObjects::core
