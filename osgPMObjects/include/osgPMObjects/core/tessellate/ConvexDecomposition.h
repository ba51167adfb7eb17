// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/EarClipping.h>
#include <osgPMObjects/core/tessellate/PolygonOutline.h>

namespace osgPMObjects::core
{

/// The most corners of a loop for which leastConvexPieces() searches: its time grows with the fifth power of
/// them.
constexpr std::size_t kMostCornersForLeastPieces = 128;

/// Unites triangles to convex pieces: at most four times the least number of pieces. Pieces are
/// counter-clockwise and may have straight corners. `triangles`: counter-clockwise, in one plane, meeting
/// along whole edges.
/// Cost: n log n. Source: Hertel & Mehlhorn, "Fast triangulation of the plane with respect to simple
/// polygons" (1985); Jin, *Polygon Techniques*, "quick and dirty".
std::vector<Loop> uniteConvex(std::span<const glm::dvec2> points, std::span<const Triangle> triangles);

/// Finds the least number of convex pieces whose corners are all corners of the loop. Returns nothing if the
/// loop has more than kMostCornersForLeastPieces corners or is not simple. A loop made by bridgeHoles() is
/// cut along its bridges; without this restriction fewer pieces may be possible, but the problem for polygons
/// with holes is NP-hard (Lingas 1982).
/// Source: Jin, *Polygon Techniques*, "optimal"; dynamic programming over sub-polygons after Keil,
/// "Decomposing a polygon into simpler components" (1985). Differs: the piece at each diagonal is the convex
/// chain of least cost among all chains.
std::optional<std::vector<Loop>> leastConvexPieces(std::span<const glm::dvec2> points, const Loop& loop);

enum class ConvexMethod
{
    quick,       ///< uniteConvex()
    leastPieces, ///< leastConvexPieces() for loops that are small enough, else uniteConvex()
};

/// A polygon as convex pieces, which can be drawn as fans. Corners are numbered as in Tessellation.
struct ConvexDecomposition
{
    std::vector<Loop> pieces;
    std::vector<InsertedPoint> inserted;
    bool isLeast = true; ///< true if leastConvexPieces() solved each loop, and no loop had a bridge
};

/// Divides a polygon into convex pieces. Parameters and errors: those of tessellate().
foundation::Result<ConvexDecomposition> decomposeConvex(std::span<const glm::dvec3> corners,
                                                        std::span<const std::uint32_t> contourSizes,
                                                        ConvexMethod method,
                                                        const OutlineOptions& options = {});

} // namespace osgPMObjects::core
