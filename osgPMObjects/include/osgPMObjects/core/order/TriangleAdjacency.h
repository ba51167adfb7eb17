// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// The dual graph of a mesh: which triangles share edges. Edge i of a triangle runs from corner i to corner i
/// + 1. Two triangles are neighbours if they run through the edge in opposite directions, so strips keep the
/// orientation. On an edge with more than two triangles the first ones of both directions are paired, then
/// the second ones, and so on. Triangles with equal corners have no neighbours.
/// Memory: 24 B a triangle. Cost: n log n.
class TriangleAdjacency
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    explicit TriangleAdjacency(std::span<const Triangle> triangles);

    std::uint32_t size() const { return static_cast<std::uint32_t>(_neighbours.size()); }
    std::uint32_t across(std::uint32_t triangle, int edge) const { return _neighbours[triangle][edge]; }
    const std::array<std::uint32_t, 3>& neighbours(std::uint32_t triangle) const
    {
        return _neighbours[triangle];
    }

    /// Returns the first edge of `triangle` that it shares with `neighbour`.
    int edgeTo(std::uint32_t triangle, std::uint32_t neighbour) const
    {
        const auto& all = _neighbours[triangle];
        return all[0] == neighbour ? 0 : all[1] == neighbour ? 1 : 2;
    }

private:
    std::vector<std::array<std::uint32_t, 3>> _neighbours;
};

} // namespace osgPMObjects::core
