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

/// A point that no contour has: where edges cross. Its place and attributes are the weighted sum of those of four corners,
/// the ends of both edges: half from each edge.
struct InsertedPoint
{
    std::array<std::uint32_t, 4> corners{};
    std::array<double, 4> weights{};
};

/// An edge between two points of a plane, and how often it is run through from `from` to `to`, less the times in the other
/// direction.
struct NodedEdge
{
    std::uint32_t from, to;
    std::int32_t winding; ///< not 0
};

/// Contours as edges that meet in common points only.
/// Invariant: isNoded(): no point lies inside an edge, and no edges cross or lie on one another.
struct NodedEdges
{
    std::vector<glm::dvec2> points; ///< those of the corners, then those of `inserted`
    std::vector<InsertedPoint> inserted;
    std::vector<NodedEdge>
        edges; ///< each pair of points once at most; of points that coincide the first alone
    std::uint32_t mergedCorners = 0; ///< corners at the place of one before them
    std::uint32_t crossings = 0;     ///< pairs of edges that crossed within both
    bool isSnapped = false;          ///< corners had to be moved, by at most 2^-20 of the largest coordinate
};

/// Finds where edges cross or touch, and divides them there, again and again until none do: a rounded crossing bends its
/// edges, and may bring new ones about. `corners`, `contourSizes`: as projectPolygon() returns them.
/// Cost: pairs of edges whose boxes overlap in x, a few times over.
/// Errors: nothing, when the edges cannot be told apart even on a grid of 2^-20.
/// Source: iterated snap rounding after Halperin & Packer, "Iterated snap rounding" (2002). Differs: only crossings are
/// rounded, corners stay; where that does not end, everything is put on a grid, which grows coarser until it does.
std::optional<NodedEdges> nodeEdges(std::span<const glm::dvec2> corners,
                                    std::span<const std::uint32_t> contourSizes);

/// Checks every pair of edges. Cost: quadratic; for tests.
bool isNoded(const NodedEdges& noded);

} // namespace osgPMObjects::core
