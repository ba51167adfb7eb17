// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <istream>
#include <span>
#include <string>
#include <vector>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/surface/PlanFrame.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A measured point: x to the east, y to the north, height.
using MeasuredPoint = std::array<double, 3>;

/// Reads a file of points as readPointFile() does, without holding it in memory. Calls visit(point) for each,
/// in order.
foundation::Outcome streamPointFile(const std::filesystem::path& file,
                                    const std::function<void(const MeasuredPoint&)>& visit);

/// The same from a stream; `place`: what errors name.
foundation::Outcome streamPoints(std::istream& stream, const std::string& place,
                                 const std::function<void(const MeasuredPoint&)>& visit);

/// Reads a file of points, one a line: three numbers, divided by commas, semicolons or white space; what
/// follows them is left out. Empty lines and those that begin with # are passed over, and a first line
/// without numbers.
/// Errors: no such file; a line without three numbers of at most 10^15, with its number; no point.
foundation::Result<std::vector<MeasuredPoint>> readPointFile(const std::filesystem::path& file);

/// Points on a lattice.
struct PlacedPoints
{
    std::vector<SurfacePoint> points;
    PlanFrame frame;
    double mostMoved =
        0.0; ///< greatest distance of a place from its point of the lattice, in units of the input
    std::size_t repeated = 0; ///< points left out, at a place that an earlier one has
};

/// Finds the lattice of placeOnLattice() point by point.
class LatticeFinder
{
public:
    void add(const MeasuredPoint& point);
    PlanFrame frame() const;
    double extent(std::size_t axis) const { return _high[axis] - _low[axis]; }

private:
    bool _isEmpty = true;
    MeasuredPoint _low{}, _high{};
    double _perStep = 1.0; ///< steps in a unit, a power of ten; 0: there is none of which all are multiples
};

/// Returns the lattice of placeOnLattice() for points.
PlanFrame latticeFor(std::span<const MeasuredPoint> points);

/// Puts a point on a lattice. `mostMoved`: raised to the distance of its place from there, along an axis.
SurfacePoint onLattice(const PlanFrame& frame, const MeasuredPoint& point, double& mostMoved);

/// Puts points on a lattice whose step is a power of ten, 10^-6 or more, of which all coordinates are
/// multiples, when the extent has no more than 2^26 of them; else the least step that has. Heights stay.
PlacedPoints placeOnLattice(std::span<const MeasuredPoint> points);

} // namespace osgMultiTriangulation::core
