// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "scenery/placement/Measures.h"
#include "scenery/placement/Placement.h"
#include "scenery/placement/Surroundings.h"

namespace scenery
{

/// How much higher than the 0 of an upright object the ground below it may be, and how deep wheels may be in
/// it.
/// Units: metres.
constexpr double kMostBuriedM = 0.3, kMostSunkM = 0.12;
/// The reserve of a foundation between the sampled points, and the largest distance of those points.
constexpr double kFoundationMarginM = 0.05, kRimStepM = 2.0;

/// Returns the sampled points of the base of an object: its middle and its rim, one every kRimStepM. Frame:
/// as Measures.
std::vector<glm::dvec2> basePlaces(const Measures& measures, double scale);

/// The height and the attitude of an object on the ground.
struct Footing
{
    double heightM = 0.0; ///< of its 0
    glm::dmat3 axes{1.0};
    double slopeDeg =
        0.0; ///< of the steepest line from the base's middle to its rim, or within half a metre about it
};

/// Puts an object on the ground at a point. The 0 of an upright object is at the highest ground below its
/// base, or lower if its foundation has to reach the lowest ground. A tilted object lies in the plane that
/// fits the corners of its base, as low as its lowest wheel needs. Returns nothing where ground is missing or
/// more uneven than the foundation, kMostBuriedM or kMostSunkM allow.
/// Cost: a height query for each point of the base.
std::optional<Footing> standOn(const Ground& ground, const Measures& measures, glm::dvec2 place,
                               double headingRad, double scale);

} // namespace scenery
