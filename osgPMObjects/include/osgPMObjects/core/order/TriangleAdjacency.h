// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>

namespace osgPMObjects::core
{

/// Which triangles share edges: the dual graph. Edge i of a triangle runs from corner i to corner i + 1.
/// Two triangles are neighbours when one runs through the edge in the other direction, so strips keep the orientation. Of an
/// edge with more than two triangles the first of either direction are paired, and so on. Triangles with equal corners have
/// no neighbours.
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

    /// The edge of `triangle` that it shares with `neighbour`; the first, if there are several.
    int edgeTo(std::uint32_t triangle, std::uint32_t neighbour) const
    {
        const auto& all = _neighbours[triangle];
        return all[0] == neighbour ? 0 : all[1] == neighbour ? 1 : 2;
    }

private:
    std::vector<std::array<std::uint32_t, 3>> _neighbours;
};

} // namespace osgPMObjects::core
