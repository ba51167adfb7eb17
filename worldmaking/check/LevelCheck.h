// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "worldmaking/land/PlanHeight.h"
#include "worldmaking/land/RoadRoom.h"

namespace worldmaking
{

/// What the ground of a runway or of open water does at worst. Units: metres; slopes in metres a metre.
struct LevelFigures
{
    double slope = 0.0;       ///< along a runway, between places 10 m apart; of water, in any direction
    double slopeChange = 0.0; ///< along a runway, from one 10 m to the next
    double crossfall = 0.0;   ///< from a runway's middle to its edges
    double lowShore =
        0.0;             ///< share of a shore whose ground, 6 m beyond, lies more than 0.3 m below the water
    bool isKnown = true; ///< false: some place has no ground
};

/// Measures the paving of a runway: three lines along it, places each 10 m. `elevationM` in the samples' datum, so that the Earth's bend
/// does not count.
LevelFigures runwayFigures(const glm::dvec2& from, const glm::dvec2& to, double widthM,
                           const PlanHeight& elevationM);

/// Measures open water: places each 10 m within it, and its shore each 10 m.
LevelFigures waterFigures(const PlanRings& rings, const PlanHeight& elevationM);

/// Tells whether a runway can be rolled along: no steeper than 2.5 %, changes of slope up to 1 %, crossfall up to 2.5 %.
bool isEvenRunway(const LevelFigures& figures);

/// Tells whether water lies as water does: no steeper than 10 % (rivers fall), and above its shore along a tenth of it at most (a river may leave).
bool isEvenWater(const LevelFigures& figures);

} // namespace worldmaking
