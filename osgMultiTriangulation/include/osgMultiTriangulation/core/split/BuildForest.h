// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/split/TreeCount.h>
#include <osgMultiTriangulation/core/structure/Forest.h>

namespace osgMultiTriangulation::core
{

struct ForestOptions
{
    std::uint32_t treeCount = 0;         ///< rectangles; 0: balancedTreeCount()
    std::optional<BorderModel> border{}; ///< absent: fitBorder()
    SplitAt where = SplitAt::centre;
    unsigned jobs = 1; ///< threads; the result does not depend on it
    /// Told after each tree: how many of all are done. Called by one thread at a time. Returns whether to go
    /// on.
    std::function<bool(std::uint32_t done, std::uint32_t all)> progress{};
};

/// What a build came to.
struct ForestReport
{
    std::uint32_t rectangles = 0, trees = 0;
    std::uint32_t largestTree = 0, smallestTree = 0; ///< points of the drains of rectangles
    std::uint32_t mainPart = 0;                      ///< points of the main part's drain
    double borderPoints = 0.0;                       ///< mean number that stays on the border of a rectangle
};

struct BuiltForest
{
    Forest forest;
    ForestReport report;
};

/// Builds a split multi-triangulation. The points are divided into rectangles. In each rectangle a tree is
/// built by simplification; points with triangles that reach out of it stay, and half of the others. Then two
/// neighbouring rectangles are joined, the triangles between them are added, and what is left of them is
/// simplified by a half again, former borders included. So it goes on up to the whole, which is simplified
/// completely: the main part. So no border stays at full resolution, and each tree, whatever its level, has
/// about as many points as a rectangle. The simplification is that of buildTree(), with errors over all
/// points.
/// `mesh`: checkInput() finds nothing. Errors: stopped by `progress`. Deterministic. Cost: 10 to 14 µs a
/// point (on a busy machine).
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 3;
/// joining in pairs after Hoppe, *Smooth view-dependent level-of-detail control and its application to
/// terrain rendering* (1998), section 5. Differs from the first: trees are simplified by a half, not to their
/// coarsest, and the main part is split along the same rectangles.
foundation::Result<BuiltForest> buildForest(const SurfaceMesh& mesh, const ForestOptions& options = {});

} // namespace osgMultiTriangulation::core
