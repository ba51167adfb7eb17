// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/control/flight/FlightGuidance.h"

namespace simulation
{

/// A strip to take off from and land on, in one direction. Frame: the scene's. Units: metres, radians.
struct RunwayStrip
{
    glm::dvec3 threshold{0.0}; ///< middle of the end at which one lands
    double course = 0.0;       ///< from north, clockwise
    double lengthM = 800.0;
    double widthM = 30.0;

    CourseLine centreLine() const { return {glm::dvec2(threshold), course}; }
};

} // namespace simulation
