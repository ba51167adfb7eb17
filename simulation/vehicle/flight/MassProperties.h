// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// Mass, centre and inertia of a loaded aircraft. Units: kg, m, kg m².
struct MassProperties
{
    double massKg = 0.0;
    glm::dvec3 centre{0.0};  ///< structural frame
    glm::dmat3 inertia{1.0}; ///< about the centre, axes forward, right, down
    glm::dmat3 inverse{1.0}; ///< of the inertia
};

/// Adds up the empty aircraft, its loads and its fuel as points (parallel axes). `fuelKg`: one for each tank.
MassProperties massProperties(const AircraftData& aircraft, std::span<const double> fuelKg);

/// A structural place relative to the centre of mass, axes forward, right, down.
inline glm::dvec3 bodyPlace(const glm::dvec3& place, const glm::dvec3& centre)
{
    return {centre.x - place.x, place.y - centre.y, centre.z - place.z};
}

} // namespace simulation
