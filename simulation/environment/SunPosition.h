// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/environment/DateTime.h"

namespace simulation
{

/// The direction of the sun as an observer sees it.
/// Units: degrees; azimuth clockwise from north, 0…360; elevation above the geometric horizon, without
/// refraction.
struct SunDirection
{
    double azimuthDeg = 0.0;
    double elevationDeg = 0.0;
};

/// Computes the direction of the sun for a position and an instant.
/// Error: below 0.02° from 1950 to 2050. The difference of dynamical and universal time is taken as 69 s;
/// refraction (0.5° at the horizon) and parallax (0.002°) are left out. Cost: about twelve trigonometric
/// functions.
/// Source: Meeus, *Astronomical Algorithms*, 2nd edition, 1998, chapters 12, 13, 22, 25 (the low-accuracy
/// method).
SunDirection sunDirection(const DateTime& utc, double latitudeDeg, double longitudeDeg);

/// The direction of the sun seen from the middle of the Earth: right ascension and declination. Units:
/// degrees.
struct SunEquatorial
{
    double rightAscensionDeg = 0.0; ///< 0…360
    double declinationDeg = 0.0;
};

/// `julianEphemerisDay`: days of dynamical time.
SunEquatorial sunEquatorial(double julianEphemerisDay);

/// Greenwich mean sidereal time of a Julian day of universal time. Units: degrees, 0…360.
double greenwichSiderealDeg(double julianDay);

} // namespace simulation
