// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scenery/placement/Measures.h"
#include "scenery/placement/Placement.h"
#include "scenery/placement/Surroundings.h"

namespace scenery
{

/// How much higher than an upright object's 0 the ground may be under it, and how far wheels may be in it. Units: metres.
constexpr double kMostBuriedM = 0.3, kMostSunkM = 0.12;
/// What a foundation keeps in hand between the places that are looked at, which are at most this far apart.
constexpr double kFoundationMarginM = 0.05, kRimStepM = 2.0;

/// Places of an object's base that are looked at: its middle, and its rim. Frame: as Measures. Cost: one every kRimStepM.
std::vector<glm::dvec2> basePlaces(const Measures& measures, double scale);

/// How an object stands on the ground.
struct Footing
{
    double heightM = 0.0; ///< of its 0
    glm::dmat3 axes{1.0};
    double slopeDeg =
        0.0; ///< of the steepest line from the base's middle to its rim, or within half a metre about it
};

/// Stands an object at a place. An upright one has its 0 where the ground is highest under its base, or lower, as far as its foundation
/// has to reach the lowest ground; a tilted one lies in the plane that fits the corners of its base, and as low as the lowest wheel asks for.
/// Nothing: ground is missing, or more uneven than foundation, kMostBuriedM or kMostSunkM allow.
/// Cost: a query of the ground for each place of the base.
std::optional<Footing> standOn(const Ground& ground, const Measures& measures, glm::dvec2 place,
                               double headingRad, double scale);

} // namespace scenery
