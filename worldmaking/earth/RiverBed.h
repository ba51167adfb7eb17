// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "worldmaking/land/RoadRoom.h"

namespace worldmaking
{

/// The bed of a river across one place of its line. Frame: the plane. Units: metres.
struct RiverBed
{
    glm::dvec2 middle{0.0};
    double widthM = 0.0;
};

/// Returns the bed of a river within its area, across a place of its line: from shore to shore, so that the bed fills the area wherever the line
/// lies in it. Nothing: the place is outside, or no shore within kMostHalfM on some side. `along`: any length.
std::optional<RiverBed> bedAcross(const PlanRings& area, const glm::dvec2& place, const glm::dvec2& along);

inline constexpr double kMostHalfM = 100.0;

} // namespace worldmaking
