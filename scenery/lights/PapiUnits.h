// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "scenery/lights/LightPoint.h"

namespace scenery
{

/// One unit of a precision approach path indicator. Frame: the scene's.
struct PapiUnit
{
    glm::dvec3 place{0.0};
    glm::dvec2 towards{1.0, 0.0}; ///< unit vector to where aircraft come from
    double angleDeg = 3.0;        ///< white is seen above it, red below
};

/// Returns the four units of a runway's end: at the left edge beside the aiming point, 15 m from the edge and
/// 9 m apart, the innermost the steepest: 2°30', 2°50', 3°10', 3°30'. `landing`: unit vector. Heights are
/// left 0.
/// Source: ICAO, *Annex 14*, volume I, 5.3.5; EASA CS-ADR-DSN.L.540 for the aiming point.
std::vector<PapiUnit> papiUnits(const glm::dvec2& threshold, const glm::dvec2& landing, double lengthM,
                                double widthM);

/// Returns the lamp of a unit, half a metre above its place.
LightPoint lampOf(const PapiUnit& unit);

} // namespace scenery
