// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// How a polygon in space becomes one in the plane.
enum class ProjectionRule
{
    largestArea, ///< drops the coordinate whose removal leaves the largest area: exact, for flat polygons
    averageNormal, ///< onto the plane across the average normal: for warped ones, which may overlap themselves otherwise
    automatic, ///< by largest area, unless edges cross there and fewer do along the average normal
};

/// Twice the area of a closed contour, as a vector along its average normal, by the right-hand rule. Units: those of the
/// corners, squared. Source: Newell's method, as in paper 002, "projection".
glm::dvec3 areaVector(std::span<const glm::dvec3> contour);

/// The corners in the plane, scaled by a power of two so that coordinates are at most 1 in size, and those below 2^-200
/// are zero: what orientation() asks. The largest contour runs counter-clockwise, unless its area is zero.
/// `corners`: all contours, one after the other; `contourSizes`: of each. Finite. `rule` is not automatic.
/// Source: paper 002, "projection": area test and normal test. A contour whose parts cancel out (a bow-tie) has no average
/// normal; it is projected along the axis in which its triangles from the first corner have the largest absolute areas.
std::vector<glm::dvec2> projectPolygon(std::span<const glm::dvec3> corners,
                                       std::span<const std::uint32_t> contourSizes, ProjectionRule rule);

} // namespace osgPMObjects::core
