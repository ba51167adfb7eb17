// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/split/TreeCount.h>

namespace osgMultiTriangulation::core
{

/// The rectangles in which a round of fitBorder() counts: those that the model so far asks for.
class BorderTrial
{
public:
    static constexpr int kRounds = 3;

    BorderTrial(const PointScan& scan, std::uint64_t points, SplitAt where, const BorderModel& model);

    bool hasBorders() const { return _partition.rectangles > 1; }
    std::uint32_t partAt(const SurfacePoint& point) const { return _partition.partAt(point); }

    /// Returns the model by the points of triangles whose corners lie in several rectangles.
    BorderModel fitted(std::uint64_t borderPoints) const;

private:
    double _points;
    Partition _partition;
};

} // namespace osgMultiTriangulation::core
