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

/// A polygon as triangles. Corners are numbered in the order of the contours; inserted points follow them.
/// Invariant: in projection the triangles do not overlap, none has area zero, and together they are the inside; every
/// point on the border of one of them is a corner of it.
struct Tessellation
{
    std::vector<Triangle> triangles;
    std::vector<InsertedPoint> inserted;
    std::uint32_t crossings = 0;     ///< pairs of edges that crossed: a bow-tie has one
    std::uint32_t unusedCorners = 0; ///< of no triangle: spikes, corners at the place of others, zero areas
    std::uint32_t bridges = 0;       ///< holes
};

/// Concave polygons, several contours, holes, contours that touch or cross each other or themselves: see PolygonOutline.
/// Errors: those of outlinePolygon(). A polygon without area is no error: no triangles.
/// Source: paper 002, "tessellation". Cost: see EarClipping.h.
foundation::Result<Tessellation> tessellate(std::span<const glm::dvec3> corners,
                                            std::span<const std::uint32_t> contourSizes,
                                            const OutlineOptions& options = {});

} // namespace osgPMObjects::core
