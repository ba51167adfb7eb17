// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
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
    std::uint32_t axis = 0; ///< of one that is halved: 0 x, 1 y
    double cut = 0.0;       ///< points whose coordinate is below it are in the first half

    bool isWhole() const { return halves[0] == kNone; }
};

/// Points divided into rectangles, each halved across its longer side.
struct Partition
{
    std::vector<PlanPart> parts;  ///< parents before their halves; 0 has all points
    std::uint32_t rectangles = 0; ///< number of parts that are not halved

    /// Returns the rectangle of a place: a part that is not halved.
    std::uint32_t partAt(const SurfacePoint& point) const;

    /// Returns the smallest part that holds the points of both. `a`, `b`: numbers of parts.
    std::uint32_t common(std::uint32_t a, std::uint32_t b) const;

    /// Returns the depth of a part, at most 255, as it is noted for points.
    std::uint8_t joinDepth(std::uint32_t part) const
    {
        return static_cast<std::uint8_t>(parts[part].depth < 255 ? parts[part].depth : 255);
    }
};

/// Calls visit(points) for runs of points until all have been seen. The same points in every call.
using PointScan = std::function<void(const std::function<void(std::span<const SurfacePoint>)>& visit)>;

/// Divides points into rectangles of about `target` points. A rectangle is done when its own number of points
/// is nearer to `target` than half of it, or a half would be empty.
/// `scan`: passes over the points; one for each level of the partition, three for a median. Sums are exact up
/// to 2^27 points, so the order of points does not matter. Cost: n log n. Memory: 150 B a rectangle, 2.2 kB
/// with the median.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 3.
Partition partitionPoints(const PointScan& scan, double target, SplitAt where = SplitAt::centre);

Partition partitionPoints(std::span<const SurfacePoint> points, double target,
                          SplitAt where = SplitAt::centre);

} // namespace osgMultiTriangulation::core
