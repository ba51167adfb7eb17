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

/// How many corners a loop may have for the least number of convex pieces to be looked for: the search takes the fifth power
/// of it at worst.
constexpr std::size_t kMostCornersForLeastPieces = 128;

/// Unites triangles as long as pieces stay convex: at most four times the least number of pieces. Pieces are counter-clockwise;
/// straight corners are allowed. `triangles`: of one plane, counter-clockwise, that meet along whole edges.
/// Cost: n log n. Source: Hertel & Mehlhorn, "Fast triangulation of the plane with respect to simple polygons" (1985);
/// paper 002, "quick and dirty".
std::vector<Loop> uniteConvex(std::span<const glm::dvec2> points, std::span<const Triangle> triangles);

/// The least number of convex pieces with corners of the loop only. Errors: nothing, when it has more than
/// kMostCornersForLeastPieces corners or is no simple loop.
/// A loop that bridgeHoles() made is cut along its bridges, so of polygons with holes other pieces may be fewer: for them
/// the problem is NP-hard (Lingas 1982).
/// Source: paper 002, "optimal"; dynamic programming over sub-polygons as by Keil, "Decomposing a polygon into simpler
/// components" (1985), but for the piece at each diagonal: a convex chain of least cost, searched among all.
std::optional<std::vector<Loop>> leastConvexPieces(std::span<const glm::dvec2> points, const Loop& loop);

enum class ConvexMethod
{
    quick,       ///< uniteConvex()
    leastPieces, ///< leastConvexPieces() for loops that are small enough
};

/// A polygon as convex pieces, to be drawn as fans. Corners are numbered as in Tessellation.
struct ConvexDecomposition
{
    std::vector<Loop> pieces;
    std::vector<InsertedPoint> inserted;
    bool isLeast =
        true; ///< of each loop, leastConvexPieces() found the least number of pieces, and it had no bridge
};

/// Errors: those of tessellate().
foundation::Result<ConvexDecomposition> decomposeConvex(std::span<const glm::dvec3> corners,
                                                        std::span<const std::uint32_t> contourSizes,
                                                        ConvexMethod method,
                                                        const OutlineOptions& options = {});

} // namespace osgPMObjects::core
