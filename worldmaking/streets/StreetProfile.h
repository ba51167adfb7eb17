// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <osgRoads/core/geometry/Cubic.h>

#include "worldmaking/streets/HeightNodes.h"

namespace worldmaking
{

/// The plane in which a crossing lies. Units: metres.
struct CrossingPlane
{
    glm::dvec2 middle{0.0}, gradient{0.0};
    double heightM = 0.0; ///< at the middle

    double at(const glm::dvec2& plan) const { return heightM + glm::dot(gradient, plan - middle); }

    /// The rise in the direction of a line, metres per metre.
    double gradeAlong(const osgRoads::core::PlanPoint& point) const
    {
        return glm::dot(gradient, point.tangent());
    }

    /// The lean to the left of a line, metres per metre.
    double leanAcross(const osgRoads::core::PlanPoint& point) const
    {
        const glm::dvec2 tangent = point.tangent();
        return glm::dot(gradient, glm::dvec2(-tangent.y, tangent.x));
    }
};

/// The heights of a road: that of its reference line, and how it leans into the planes of the crossings at
/// its ends. s counts from where the road begins.
struct StreetProfile
{
    osgRoads::core::CubicProfile elevation, superelevationRad;
};

/// The planes at the ends of a road; null where it ends in the open.
struct EndPlanes
{
    const CrossingPlane* start = nullptr;
    const CrossingPlane* end = nullptr;

    /// Whether both ends lie in the plane of one area, and the road with them.
    bool isOne() const { return start && start == end; }
};

/// Makes the profile of a road from the heights of its nodes: the pieces of a uniform cubic B-spline, nowhere
/// steeper than from node to node. At its ends it has exactly the height, the grade and the lean of the
/// planes; it lies in them as far as its nodes are held there, and all along where both are one; else it
/// comes upright over 25 m, or where there is no room goes straight over from one to the other.
/// Source: Farin, *Curves and Surfaces for CAGD*, 2002, chapter 8.
StreetProfile profileOf(const HeightRow& row, std::vector<double> heightsM, const EndPlanes& planes);

} // namespace worldmaking
