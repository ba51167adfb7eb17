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

/// A polygon in the plane, ready to be cut: each part of its inside is one loop, without holes, that neither crosses itself
/// nor others. Numbers of points: the corners of all contours in their order, then the inserted ones.
struct PolygonOutline
{
    std::vector<glm::dvec2> points;
    std::vector<InsertedPoint> inserted;
    std::vector<Loop> loops;     ///< counter-clockwise
    std::uint32_t crossings = 0; ///< pairs of edges that crossed: a bow-tie has one
    std::uint32_t unusedCorners =
        0;                     ///< at the place of another one, or not on the border: spikes, zero areas
    std::uint32_t bridges = 0; ///< holes joined to what surrounds them
    bool isSnapped = false;    ///< see NodedEdges
    bool isAlongAverageNormal = false; ///< how it was projected
};

/// `corners`: of all contours, one after the other; `contourSizes`: how many each has; whatever they are like.
/// The inside lies left of the largest contour: triangles have its direction.
/// Errors: sizes that do not add up, coordinates that are not finite, edges that cannot be told apart.
foundation::Result<PolygonOutline> outlinePolygon(std::span<const glm::dvec3> corners,
                                                  std::span<const std::uint32_t> contourSizes,
                                                  const OutlineOptions& options = {});

/// Where an inserted point lies in space.
glm::dvec3 placeOf(const InsertedPoint& inserted, std::span<const glm::dvec3> corners);

} // namespace osgPMObjects::core
