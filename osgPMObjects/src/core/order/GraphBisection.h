// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/order/TriangleAdjacency.h>

namespace osgPMObjects::core
{

/// Divides sets of triangles into halves with few neighbours in different halves.
/// Memory: 17 B a triangle of the mesh. Cost: linear in the set.
/// Source: halves from breadth-first search, improved after Fiduccia & Mattheyses, "A linear-time heuristic
/// for improving network partitions" (1982).
class GraphBisection
{
public:
    explicit GraphBisection(const TriangleAdjacency& adjacency);

    /// Sorts the triangles so that one half precedes the other; returns the size of the first half, ½ ± 1/16
    /// of all. A half may be halved again; sets that are halved side by side must not share triangles.
    std::size_t halve(std::span<std::uint32_t> triangles);

private:
    struct Move
    {
        std::uint32_t triangle;
        int cut; ///< edges between the halves after this move
    };

    std::uint32_t search(std::span<std::uint32_t> triangles, std::uint32_t first);
    void mend(std::span<const std::uint32_t> triangles, std::size_t target);
    bool improve(std::span<const std::uint32_t> triangles, std::size_t slack);
    int gain(std::uint32_t triangle) const;
    void addCandidate(std::uint32_t triangle);
    std::uint32_t bestMove(std::size_t slack);

    const TriangleAdjacency& _adjacency;
    std::vector<std::uint32_t> _set;              ///< by triangle: the last set that it was in
    std::vector<std::uint32_t> _seen;             ///< by triangle: the last search that reached it
    std::vector<std::uint32_t> _moved;            ///< by triangle: the last pass that moved it
    std::vector<char> _isSecond;                  ///< by triangle: whether it is in the second half
    std::vector<std::uint32_t> _found;            ///< the triangles of a search, in its order
    std::vector<std::uint32_t> _candidates[2][7]; ///< by half and gain + 3: candidates for a move
    std::uint32_t _sets = 0, _searches = 0, _passes = 0;
    std::ptrdiff_t _excess = 0; ///< triangles that the first half has above its target
};

} // namespace osgPMObjects::core
