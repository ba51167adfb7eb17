// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/vec2.hpp>

#include <osgRoads/core/network/Road.h>

#include "worldmaking/streets/StreetProfile.h"

namespace worldmaking
{

/// The left edge of a lane, seen in the direction of its traffic, where it meets a crossing. Units: metres,
/// radians.
struct LaneGate
{
    glm::dvec2 edge{0.0};
    double headingRad = 0.0; ///< of the traffic
    double widthM = 0.0;
};

/// Returns the cubic from s on that has a value and a slope at its start and at its end.
osgRoads::core::Cubic hermitePiece(double s, double lengthM, double value, double slope, double nextValue,
                                   double nextSlope);

/// Makes the road that leads from one lane to another across a crossing: one lane to the right of a cubic
/// that meets both edges in place and heading, on the crossing's plane. Its id, links and junction are the
/// caller's.
/// Source: Farin, *Curves and Surfaces for CAGD*, 2002, chapter 7 (cubic Hermite interpolation; tangents as
/// long as an arc of the same turn has them).
osgRoads::core::Road connectingRoad(const LaneGate& from, const LaneGate& to, const CrossingPlane& plane);

} // namespace worldmaking
