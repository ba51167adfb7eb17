// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/environment/DateTime.h"

namespace simulation
{

/// Where the sun stands in an observer's sky.
/// Units: degrees; azimuth from north over east, 0…360; elevation above the geometric horizon, no refraction.
struct SunDirection
{
    double azimuthDeg = 0.0;
    double elevationDeg = 0.0;
};

/// The sun as seen at a place and time.
/// Error: below 0.02° from 1950 to 2050; the difference of dynamical and universal time is taken as 69 s, and
/// refraction (0.5° at the horizon) and parallax (0.002°) are left out.
/// Cost: about a dozen trigonometric functions.
/// Source: Meeus, Astronomical Algorithms, 2nd ed., chapters 12, 13, 22, 25 (the low-accuracy method).
SunDirection sunDirection(const DateTime& utc, double latitudeDeg, double longitudeDeg);

/// The same, geocentric: right ascension and declination. Units: degrees.
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
