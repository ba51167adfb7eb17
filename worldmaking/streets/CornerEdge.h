// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include <osgRoads/core/network/Road.h>

namespace worldmaking
{

/// One side of an arm where it meets a crossing: the border of its carriageway and what lies beside it.
/// Units: metres, radians.
struct ArmSide
{
    glm::dvec2 edge{0.0};
    double headingRad = 0.0; ///< along the border: towards the crossing or away from it
    double shoulderM = 0.0, sidewalkM = 0.0;
};

/// Both sides of an arm, seen from traffic that keeps to the right.
struct ArmSides
{
    ArmSide in;  ///< to the right of traffic towards the crossing
    ArmSide out; ///< to the right of traffic away from it
};

/// Returns the sides of a road at its start or end.
ArmSides sidesOf(const osgRoads::core::Road& road, bool isEnd);

/// Whether the borders of two arms leave a corner between them: neither begins within the other arm.
bool haveCorner(const ArmSide& from, const ArmSide& to);

/// A line from a point in a direction.
struct HalfLine
{
    glm::dvec2 start{0.0}, way{1.0, 0.0};
};

/// The lines of two streets from the middle of their crossing.
struct CornerLines
{
    HalfLine from, to;
};

/// Makes a connecting road the edge of its crossing: outside of its lanes it gets the shoulder and the
/// sidewalk of both arms, which go over into each other, and to its left a paved lane as far as the lines of
/// both streets. The edges of all corners together pave the crossing.
/// Frame: the network's plan. The paving has the type `special`: it carries nobody along.
void addEdge(osgRoads::core::Road& road, const ArmSide& from, const ArmSide& to, const CornerLines& lines);

} // namespace worldmaking
