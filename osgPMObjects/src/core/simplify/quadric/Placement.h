// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "StarQuadric.h"

namespace osgPMObjects::core
{

/// What an edge's two ends know of their stars.
struct StarShape
{
    Quadric quadric;            ///< its origin at the position
    glm::dvec3 areaVector{0.0}; ///< sum of the faces' normals, each as long as twice its area
};

/// An edge whose two positions are to become one.
struct CollapsingEdge
{
    glm::dvec3 from, to;
    const StarShape& fromShape;
    const StarShape& toShape;
    glm::dvec3 sharedAreaVector; ///< of the faces beside the edge, which are in both stars
};

/// The quadrics of both ends at a place.
double costAt(const CollapsingEdge& edge, const glm::dvec3& at);

/// The place where the sum of both quadrics is least among those that keep the volume; near the middle along directions
/// that change nothing, and never farther from the middle than the edge is long.
/// Source: Lindstrom and Turk (1998), §3.1 and §3.3: we solve for the least quadric with the volume as a constraint, pulled
/// weakly towards the middle, instead of adding constraints until three are independent.
glm::dvec3 bestPlace(const CollapsingEdge& edge);

} // namespace osgPMObjects::core
