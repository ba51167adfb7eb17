// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Heights.h>

#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// What the ground of a runway or of open water does at worst. Units: metres; slopes in metres a metre.
struct LevelFigures
{
    /// along a runway, between places 10 m apart; of water, in any direction, but of a river away from its
    /// course
    double slope = 0.0;
    double fall = 0.0, rise = 0.0; ///< of a river along its course, between places 10 m apart
    double slopeChange = 0.0;      ///< along a runway, from one 10 m to the next
    double crossfall = 0.0;        ///< from a runway's middle to its edges
    double lowShore =
        0.0;             ///< share of a shore whose ground, 6 m beyond, lies more than 0.3 m below the water
    bool isKnown = true; ///< false: some place has no ground
    glm::dvec2 steepAt{0.0}; ///< of water: from where it is steepest, in the frame of its rings
};

/// Measures the paving of a runway: three lines along it, places each 10 m. `elevationM` in the samples'
/// datum, so that the Earth's bend does not count.
LevelFigures runwayFigures(const glm::dvec2& from, const glm::dvec2& to, double widthM,
                           const foundation::HeightInPlan& elevationM);

/// Measures open water: places each 10 m within it, and its shore each 10 m. A river falls along its course,
/// and is as high beside it: a place within kCourseM of a course (`courses`: lines, downstream) counts by its
/// height above the course there, 0.3 m left out. Where a course leads out of the area there is no shore.
LevelFigures waterFigures(const PlanRings& rings, const PlanRings& courses,
                          const foundation::HeightInPlan& elevationM);

inline constexpr double kCourseM = 60.0;

/// Tells whether a runway can be rolled along: no steeper than 2.5 %, changes of slope up to 1 %, crossfall
/// up to 2.5 %.
bool isEvenRunway(const LevelFigures& figures);

/// Tells whether water lies as water does: no steeper than 10 %, a river along its course no steeper than a
/// rapid (50 %) and nowhere upwards (3 %), and above its shore along a tenth of it at most (a river may
/// leave).
bool isEvenWater(const LevelFigures& figures);

} // namespace worldmaking
