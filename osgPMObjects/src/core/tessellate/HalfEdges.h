// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>

namespace osgPMObjects::core
{

/// The half-edge structure of noded edges: edge e is the half-edge 2e from → to, and 2e + 1 in the opposite
/// direction.
/// Invariant: the NodedEdges satisfy isNoded(), and outlive this object.
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
    const glm::dvec2& position(std::uint32_t point) const { return _noded.points[point]; }
    std::span<const glm::dvec2> points() const { return _noded.points; }

    /// Returns the winding number on the left of a half-edge minus that on its right.
    std::int32_t windingStep(std::uint32_t half) const
    {
        const std::int32_t winding = _noded.edges[half / 2].winding;
        return half % 2 == 0 ? winding : -winding;
    }

    /// Returns the next half-edge with the same origin, clockwise.
    std::uint32_t clockwise(std::uint32_t half) const { return _clockwise[half]; }
    /// Returns the next half-edge around the face to the left.
    std::uint32_t next(std::uint32_t half) const { return _clockwise[half ^ 1u]; }

private:
    void sortAround(std::span<std::uint32_t> fan);

    const NodedEdges& _noded;
    std::vector<std::uint32_t> _clockwise;
};

/// Returns by half-edge the winding number of the region to its left.
std::vector<std::int32_t> windingNumbers(const HalfEdges& halves);

} // namespace osgPMObjects::core
