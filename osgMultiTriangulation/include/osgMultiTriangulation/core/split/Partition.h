// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Where a rectangle is divided.
enum class SplitAt
{
    centre, ///< the geometric centre of its points, as in the paper
    median, ///< as many points on both sides; for skewed sets
};

/// A rectangle of the plan with its points, or both halves of one.
struct PlanPart
{
    std::uint32_t parent = kNone;
    std::uint32_t halves[2] = {kNone, kNone}; ///< numbers of parts, or kNone
    std::uint32_t depth = 0;                  ///< 0: the whole
    std::uint32_t points = 0;

    bool isWhole() const { return halves[0] == kNone; }
};

/// Points divided into rectangles, each halved across its longer side.
struct Partition
{
    std::vector<PlanPart> parts;       ///< parents before their halves; 0 has all points
    std::vector<std::uint32_t> partOf; ///< by point: its rectangle, a part that is not halved
    std::uint32_t rectangles = 0;      ///< number of parts that are not halved

    /// Returns the smallest part that holds the points of both. `a`, `b`: numbers of parts.
    std::uint32_t common(std::uint32_t a, std::uint32_t b) const;
};

/// Divides points into rectangles of about `target` points. A rectangle is done when its own number of points is nearer to `target`
/// than half of it, or a half would be empty.
/// Cost: n log n. Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 3.
Partition partitionPoints(std::span<const SurfacePoint> points, double target,
                          SplitAt where = SplitAt::centre);

} // namespace osgMultiTriangulation::core
