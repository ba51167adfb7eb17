// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// Points of a surface, sorted into cells of the plan, so that the error of a triangulation can be found by
/// brute force.
class PointCells
{
public:
    explicit PointCells(std::span<const SurfacePoint> points);

    /// Returns by how much the worst point is farther from a triangulation, along the vertical, than is
    /// promised there; zero or less when every promise is kept; infinite when a point is in no triangle. A
    /// point on a side needs one promise.
    /// `bounds`: by triangle, metres. With bounds of zero this is the greatest error.
    double greatestExcess(const SurfaceMesh& mesh, std::span<const float> bounds) const;

private:
    std::uint32_t cellOf(double coordinate, int axis) const;

    double _low[2] = {0.0, 0.0}, _cell = 1.0;
    std::uint32_t _cells[2] = {1, 1};
    std::vector<SurfacePoint> _points; ///< by cell
    std::vector<std::uint32_t> _first; ///< by cell, row by row, and one more
};

} // namespace osgMultiTriangulation::core
