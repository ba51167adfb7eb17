// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// The projection that takes a polygon in space to the plane.
enum class ProjectionRule
{
    largestArea, ///< drops the coordinate that leaves the largest area: exact, for flat polygons
    /// projects along the average normal: for warped polygons, which may overlap themselves otherwise
    averageNormal,
    automatic, ///< largestArea, unless edges cross there and fewer cross with averageNormal
};

/// Returns twice the area of a closed contour as a vector along its average normal, by the right-hand rule.
/// Units: those of the corners, squared. Source: Newell's method, as in Jin, *Polygon Techniques*,
/// "projection".
glm::dvec3 areaVector(std::span<const glm::dvec3> contour);

/// Projects corners onto the plane and scales them by a power of two: coordinates are at most 1, and those
/// below 2^-200 are zero, as orientation() requires. The largest contour runs counter-clockwise, unless its
/// area is zero.
/// `corners`: all contours, one after the other, finite; `contourSizes`: of each; `rule`: not automatic.
/// Source: Jin, *Polygon Techniques*, "projection": area test and normal test. A contour whose parts cancel
/// out (a bow-tie) has no average normal. It is projected along the axis for which its triangles from the
/// first corner have the largest absolute areas.
std::vector<glm::dvec2> projectPolygon(std::span<const glm::dvec3> corners,
                                       std::span<const std::uint32_t> contourSizes, ProjectionRule rule);

} // namespace osgPMObjects::core
