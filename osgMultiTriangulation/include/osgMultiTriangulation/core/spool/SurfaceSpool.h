// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/spool/RecordFile.h>
#include <osgMultiTriangulation/core/surface/HeightStep.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A surface in two files, points and triangles, for a build that has no room for it in memory.
/// Use: addPoint() and addTriangle() in any order, then finish().
/// Memory: 40 kB. Errors: no room on the disk; outcome() tells.
class SurfaceSpool
{
public:
    /// Makes the files in a folder that is there.
    static foundation::Result<SurfaceSpool> create(const std::filesystem::path& folder);

    /// Takes the points of a folder in which finish() has been called; there are no triangles. Errors: it has
    /// not this number of points.
    static foundation::Result<SurfaceSpool> openPoints(const std::filesystem::path& folder,
                                                       std::uint64_t points);

    /// Numbers points from 0 on. One that no triangle has must not be added.
    void addPoint(const SurfacePoint& point);
    void addTriangle(const Triangle& triangle);
    foundation::Outcome finish();

    const std::filesystem::path& folder() const { return _folder; }
    const RecordFile<SurfacePoint>& points() const { return _points; }
    const RecordFile<Triangle>& triangles() const { return _triangles; }
    double heightStep() const { return _heights.step(); } ///< of all heights: commonHeightStep()
    std::uint32_t sum() const { return _sum; }            ///< of all that was added

private:
    std::filesystem::path _folder;
    RecordFile<SurfacePoint> _points;
    RecordFile<Triangle> _triangles;
    HeightStep _heights;
    std::uint32_t _sum = 0;
};

} // namespace osgMultiTriangulation::core
