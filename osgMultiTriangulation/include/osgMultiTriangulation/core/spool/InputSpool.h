// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/input/PointSet.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>
#include <osgMultiTriangulation/core/surface/PlanFrame.h>

namespace osgMultiTriangulation::core
{

/// What was read into a spool.
struct SpooledInput
{
    PlanFrame frame;
    double mostMoved =
        0.0; ///< greatest distance of a place from its point of the lattice, in units of the input
    std::uint64_t repeated = 0; ///< points left out, at a place that an earlier one has
};

/// Calls visit(point) for all points, in order. Errors: what it cannot read.
using PointStream =
    std::function<foundation::Outcome(const std::function<void(const MeasuredPoint&)>& visit)>;

/// Takes points, puts them on a lattice as placeOnLattice() does, and triangulates them after Delaunay, in
/// strips across the longer side of their extent. Points are numbered strip by strip.
/// Memory: about 500 B for each of max(2^14, 8·√N) points. Errors: those of the stream; all points on one
/// line; no room.
foundation::Result<SpooledInput> spoolPoints(const PointStream& stream, SurfaceSpool& spool);

/// The same with the points of files. Errors: those of readPointFile(), too.
foundation::Result<SpooledInput> spoolPointFiles(std::span<const std::filesystem::path> files,
                                                 SurfaceSpool& spool);

/// Reads a file of triangles, and puts it on a lattice as placeTin() does: the same points and triangles in
/// the same order.
/// Memory: some MB. Time: short where triangles have points that stand near each other in the file, 2 µs a
/// corner where not.
/// Errors: those of readTinFile() and placeTin(); no room.
foundation::Result<SpooledInput> spoolTinFile(const std::filesystem::path& file, SurfaceSpool& spool);

} // namespace osgMultiTriangulation::core
