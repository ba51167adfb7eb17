// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

namespace scenery
{

using PlanRing = std::vector<glm::dvec2>;

/// The area of a ring, square metres: positive where it runs counter-clockwise.
double turnedAreaOf(const PlanRing& ring);

/// The area that rings enclose: the first without the others.
double areaOf(const std::vector<PlanRing>& rings);

/// Turns rings so that the outer one runs counter-clockwise and holes clockwise, and leaves out corners
/// nearer than 5 cm to the one before or within 2 cm of the line between their neighbours.
std::vector<PlanRing> tidiedRings(const std::vector<PlanRing>& rings);

/// Tells whether a place lies within rings, by the even-odd rule.
bool isWithin(const std::vector<PlanRing>& rings, const glm::dvec2& place);

/// The smallest rectangle around a ring.
struct PlanRectangle
{
    glm::dvec2 middle{0.0}, along{1.0, 0.0}; ///< unit direction of the longer side
    double halfLengthM = 0.0, halfWidthM = 0.0;

    glm::dvec2 across() const { return {-along.y, along.x}; }
    double area() const { return 4.0 * halfLengthM * halfWidthM; }
};

/// Finds it among those with a side along an edge of the ring.
/// Source: Freeman & Shapira, *Determining the minimum-area encasing rectangle for an arbitrary closed
/// curve*, 1975.
PlanRectangle rectangleAround(const PlanRing& ring);

/// Moves the edges of a convex ring outwards; a ring that is not convex comes back as it is.
PlanRing grownRing(const PlanRing& ring, double byM);

} // namespace scenery
