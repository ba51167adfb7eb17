// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "AccumulatedQuadric.h"
#include "StarQuadric.h"

namespace osgPMObjects::core
{

/// The quadric and the area of a position's star.
struct StarShape
{
    Quadric quadric;            ///< its origin at the position
    glm::dvec3 areaVector{0.0}; ///< sum of the faces' normals, each of twice its area's length
};

template<class IsBorder>
StarShape starShape(const Star& star, std::span<const glm::dvec3> positions, const AreaWeight& weight,
                    const IsBorder& isBorder)
{
    StarShape shape{starQuadric(star, positions, weight, isBorder)};
    for (const Star::Spoked& spoked : star.faces)
        shape.areaVector += spoked.doubleArea * spoked.normal;
    return shape;
}

/// Returns the sum of the area vectors of the faces beside an edge of a star.
glm::dvec3 sharedAreaVector(const Star& star, std::uint32_t to);

/// An edge whose two positions are to become one.
struct CollapsingEdge
{
    glm::dvec3 from, to;
    const StarShape& fromShape;
    const StarShape& toShape;
    glm::dvec3 sharedAreaVector; ///< of the faces beside the edge, which are in both stars
};

/// The sum of both quadrics at a position.
double costAt(const CollapsingEdge& edge, const glm::dvec3& at);

/// Finds the position of the least sum of both quadrics that keeps the volume. Along directions without
/// influence it is near the middle of the edge, and never farther from the middle than the edge's length.
/// Source: Lindstrom and Turk, *Fast and memory efficient polygonal simplification* (1998), sections 3.1 and
/// 3.3. Differs: minimises the quadric with the volume as a constraint and a weak pull to the middle, instead
/// of adding constraints up to three.
glm::dvec3 bestPlace(const CollapsingEdge& edge);

/// The same for a quadric that has added up, about the middle of the edge.
glm::dvec3 bestPlace(const CollapsingEdge& edge, const AccumulatedQuadric& aboutMiddle);

} // namespace osgPMObjects::core
