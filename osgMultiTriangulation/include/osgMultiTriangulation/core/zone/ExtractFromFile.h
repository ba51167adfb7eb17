// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/file/MtFile.h>
#include <osgMultiTriangulation/core/surface/SurfaceMesh.h>

namespace osgMultiTriangulation::core
{

/// A rectangle of the plan, in units of its reference; without one in those of the plan.
struct PlanRegion
{
    double west = 0.0, south = 0.0, east = 0.0, north = 0.0;
};

/// Which triangulation is taken from a file.
struct ExtractRequest
{
    double errorM = -1.0; ///< no triangle is farther from the input along the vertical; negative: all points
    std::size_t mostTriangles =
        std::numeric_limits<std::size_t>::max(); ///< the least error, no less than errorM, with no more
    /// the error holds for triangles whose box meets it; elsewhere the surface
    std::optional<PlanRegion> region;
    ///< is as coarse as it can be
};

/// A triangulation of the whole surface that was taken from a file.
struct ExtractedSurface
{
    SurfaceMesh mesh; ///< each point once
    double errorM = 0.0;
    std::size_t trees = 0; ///< that were read
};

/// Takes one triangulation of variable resolution from a file. It reads only trees that meet the region and
/// can be too coarse there; they are in memory together, completely.
/// Errors: a tree is damaged; no error has so few triangles.
/// Source: *Multi-Triangulation as applied to very large terrains visualization* (Graphicon 2005), section 5.
foundation::Result<ExtractedSurface> extractFrom(const MtFile& file, const ExtractRequest& request);

} // namespace osgMultiTriangulation::core
