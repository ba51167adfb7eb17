// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// A point at which two edges cross, and which no contour has. Its position and attributes are weighted sums
/// of those of the four ends of the edges; each edge has half of the weight.
struct InsertedPoint
{
    std::array<std::uint32_t, 4> corners{};
    std::array<double, 4> weights{};
};

/// An edge between two points of the plane. `winding` counts how often contours run along it from `from` to
/// `to`, minus the opposite direction.
struct NodedEdge
{
    std::uint32_t from, to;
    std::int32_t winding; ///< not 0
};

/// The edges of contours, divided so that they meet only in common end points.
/// Invariant: isNoded(): no point lies inside an edge, and no edges cross or overlap.
struct NodedEdges
{
    std::vector<glm::dvec2> points; ///< the corners, then the inserted points
    std::vector<InsertedPoint> inserted;
    std::vector<NodedEdge>
        edges; ///< each pair of points at most once; of equal points only the first is used
    std::uint32_t mergedCorners = 0; ///< corners at the same point as an earlier corner
    std::uint32_t crossings = 0;     ///< pairs of edges that crossed inside both
    bool isSnapped = false; ///< true if corners were moved: by at most 2^-20 of the largest coordinate
};

/// Divides edges where they cross or touch, and repeats it until none do: rounding a crossing bends its
/// edges, which may cause new crossings. `corners`, `contourSizes`: as projectPolygon() returns them. Returns
/// nothing if the edges cannot be separated even on a grid of 2^-20.
/// Cost: a few passes over the pairs of edges whose boxes overlap in x.
/// Source: after Halperin & Packer, "Iterated snap rounding" (2002). Differs: only crossings are rounded and
/// corners stay; if that does not end, all points are rounded to a grid, which grows coarser until it ends.
std::optional<NodedEdges> nodeEdges(std::span<const glm::dvec2> corners,
                                    std::span<const std::uint32_t> contourSizes);

/// Checks NodedEdges' invariant for every pair of edges. Cost: quadratic; for tests.
bool isNoded(const NodedEdges& noded);

} // namespace osgPMObjects::core
