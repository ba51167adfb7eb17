// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgPMObjects/core/tessellate/EdgeNoding.h>
#include <osgPMObjects/core/tessellate/InsideLoops.h>
#include <osgPMObjects/core/tessellate/PolygonProjection.h>

namespace osgPMObjects::core
{

struct OutlineOptions
{
    ProjectionRule projection = ProjectionRule::automatic;
    InsideRule inside = InsideRule::odd;
};

/// A polygon in the plane, ready for triangulation: each part of its inside is one loop without holes that
/// crosses neither itself nor other loops. Point numbers: the corners of all contours in their order, then
/// the inserted points.
struct PolygonOutline
{
    std::vector<glm::dvec2> points;
    std::vector<InsertedPoint> inserted;
    std::vector<Loop> loops;     ///< counter-clockwise
    std::uint32_t crossings = 0; ///< pairs of edges that crossed: a bow-tie has one
    std::uint32_t unusedCorners =
        0; ///< corners that repeat another one, or are not on the border: spikes, zero areas
    std::uint32_t bridges = 0;         ///< holes that were joined to the contour around them
    bool isSnapped = false;            ///< see NodedEdges
    bool isAlongAverageNormal = false; ///< true if projected along the average normal
};

/// Makes the outline of any polygon: concave, with holes, with contours that touch or cross.
/// `corners`: of all contours, one after the other; `contourSizes`: the number of corners of each.
/// The largest contour is taken as counter-clockwise; triangles get its orientation.
/// Errors: sizes that do not add up, coordinates that are not finite, edges that cannot be separated.
foundation::Result<PolygonOutline> outlinePolygon(std::span<const glm::dvec3> corners,
                                                  std::span<const std::uint32_t> contourSizes,
                                                  const OutlineOptions& options = {});

/// Returns the position of an inserted point in space.
glm::dvec3 positionOf(const InsertedPoint& inserted, std::span<const glm::dvec3> corners);

} // namespace osgPMObjects::core
