// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

namespace osgPMObjects::core
{

/// The edges of NodedEdges twice, once in either direction: edge e is half-edge 2e from → to, and 2e + 1 back.
/// Invariant: isNoded() of what it was made from.
class HalfEdges
{
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    explicit HalfEdges(const NodedEdges& noded);

    std::uint32_t size() const { return static_cast<std::uint32_t>(2 * _noded.edges.size()); }
    std::uint32_t origin(std::uint32_t half) const
    {
        const NodedEdge& edge = _noded.edges[half / 2];
        return half % 2 == 0 ? edge.from : edge.to;
    }
    std::uint32_t target(std::uint32_t half) const { return origin(half ^ 1u); }
    const glm::dvec2& place(std::uint32_t point) const { return _noded.points[point]; }
    std::span<const glm::dvec2> points() const { return _noded.points; }

    /// How much more often the contours run around what is left of it than around what is right of it.
    std::int32_t windingStep(std::uint32_t half) const
    {
        const std::int32_t winding = _noded.edges[half / 2].winding;
        return half % 2 == 0 ? winding : -winding;
    }

    /// The next half-edge with the same origin, turning clockwise.
    std::uint32_t clockwise(std::uint32_t half) const { return _clockwise[half]; }
    /// The next one around what lies to the left.
    std::uint32_t next(std::uint32_t half) const { return _clockwise[half ^ 1u]; }

private:
    void sortAround(std::span<std::uint32_t> fan);

    const NodedEdges& _noded;
    std::vector<std::uint32_t> _clockwise;
};

/// By half-edge: how often the contours run around what lies to the left of it.
std::vector<std::int32_t> windingNumbers(const HalfEdges& halves);

} // namespace osgPMObjects::core
