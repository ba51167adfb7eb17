// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "simulation/environment/DateTime.h"

namespace simulation
{

/// Returns the rotation from directions of J2000 (x to the equinox, z to the north pole) to east, north, up
/// at a place: precession, and the turn of the Earth. Nutation and aberration (0.01 degrees together) are
/// left out.
/// Units: degrees. Source: Meeus, *Astronomical Algorithms* (1998), chapters 12, 13 and 21.
glm::dmat3 worldFromStars(const DateTime& utc, double latitudeDeg, double longitudeDeg);

/// The moon as an observer sees it. Frame: east, north, up.
struct MoonSight
{
    glm::dvec3 towards{0.0, 0.0, -1.0}; ///< unit vector, parallax included, refraction left out
    double litShare = 0.0;              ///< of its disc, 0 new … 1 full
    double distanceKm = 385000.0;       ///< from the middle of the Earth
};

/// Computes it. Error: below 0.03 degrees from 1950 to 2050. Source: Meeus (1998), chapters 40, 47 and 48,
/// terms above 0.0035 degrees.
MoonSight moonSight(const DateTime& utc, double latitudeDeg, double longitudeDeg);

/// What light the moon gives to level ground, in that of a full moon overhead: by its phase and height. 0 …
/// 1.
/// Source: Krisciunas and Schaefer, *A model of the brightness of moonlight* (1991), equation 9.
double moonlightOf(const MoonSight& moon);

} // namespace simulation
