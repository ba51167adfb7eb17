// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/EarClipping.h>
#include <osgPMObjects/core/tessellate/PolygonOutline.h>

namespace osgPMObjects::core
{

/// A polygon as triangles. Point numbers: the corners in the order of the contours, then the inserted points.
/// Invariant: in the projection the triangles do not overlap, none has area zero, and together they are the
/// inside; each point on the border of a triangle is one of its corners.
struct Tessellation
{
    std::vector<Triangle> triangles;
    std::vector<InsertedPoint> inserted;
    std::uint32_t crossings = 0;     ///< pairs of edges that crossed: a bow-tie has one
    std::uint32_t unusedCorners = 0; ///< corners of no triangle: spikes, repeated corners, zero areas
    std::uint32_t bridges = 0;       ///< holes
};

/// Triangulates any polygon: concave, of several contours, with holes, with contours that touch or cross each
/// other or themselves; PolygonOutline.h describes the parameters. A polygon without area gives no triangles
/// and is not an error.
/// Errors: those of outlinePolygon(). Cost: see EarClipping.h. Source: Jin, *Polygon Techniques*,
/// "tessellation".
foundation::Result<Tessellation> tessellate(std::span<const glm::dvec3> corners,
                                            std::span<const std::uint32_t> contourSizes,
                                            const OutlineOptions& options = {});

} // namespace osgPMObjects::core
