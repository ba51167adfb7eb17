// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/SunPosition.h"

#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr double kJulianDay2000 = 2451545.0;
constexpr double kDaysPerCentury = 36525.0;
constexpr double kDynamicalMinusUniversalS = 69.0;

double sinDeg(double angle)
{
    return std::sin(foundation::radiansOf(angle));
}
double cosDeg(double angle)
{
    return std::cos(foundation::radiansOf(angle));
}

double turn(double angleDeg)
{
    const double rest = std::fmod(angleDeg, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest;
}

} // namespace

SunEquatorial sunEquatorial(double julianEphemerisDay)
{
    const double t = (julianEphemerisDay - kJulianDay2000) / kDaysPerCentury;
    const double meanLongitude = 280.46646 + t * (36000.76983 + t * 0.0003032);
    const double anomaly = turn(357.52911 + t * (35999.05029 - t * 0.0001537));
    const double centre = (1.914602 - t * (0.004817 + t * 0.000014)) * sinDeg(anomaly) +
                          (0.019993 - t * 0.000101) * sinDeg(2.0 * anomaly) +
                          0.000289 * sinDeg(3.0 * anomaly);
    const double node = turn(125.04 - 1934.136 * t);
    const double apparentLongitude = turn(meanLongitude + centre - 0.00569 - 0.00478 * sinDeg(node));
    const double meanObliquity = 23.43929111 - t * (0.013004167 + t * (1.639e-7 - t * 5.036e-7));
    const double obliquity = meanObliquity + 0.00256 * cosDeg(node);
    SunEquatorial sun;
    sun.rightAscensionDeg = turn(foundation::degreesOf(
        std::atan2(cosDeg(obliquity) * sinDeg(apparentLongitude), cosDeg(apparentLongitude))));
    sun.declinationDeg = foundation::degreesOf(std::asin(sinDeg(obliquity) * sinDeg(apparentLongitude)));
    return sun;
}

double greenwichSiderealDeg(double julianDay)
{
    const double days = julianDay - kJulianDay2000;
    const double t = days / kDaysPerCentury;
    return turn(280.46061837 + 360.98564736629 * days + t * t * (0.000387933 - t / 38710000.0));
}

SunDirection sunDirection(const DateTime& utc, double latitudeDeg, double longitudeDeg)
{
    const double julianDay = utc.julianDay();
    const SunEquatorial sun = sunEquatorial(julianDay + kDynamicalMinusUniversalS / 86400.0);
    const double hourAngle = turn(greenwichSiderealDeg(julianDay) + longitudeDeg - sun.rightAscensionDeg);
    const double sinElevation = sinDeg(latitudeDeg) * sinDeg(sun.declinationDeg) +
                                cosDeg(latitudeDeg) * cosDeg(sun.declinationDeg) * cosDeg(hourAngle);
    // Components of the direction towards the sun, multiplied out so that nothing is divided by
    // cos(declination).
    const double east = -cosDeg(sun.declinationDeg) * sinDeg(hourAngle);
    const double north = sinDeg(sun.declinationDeg) * cosDeg(latitudeDeg) -
                         cosDeg(sun.declinationDeg) * cosDeg(hourAngle) * sinDeg(latitudeDeg);
    return {turn(foundation::degreesOf(std::atan2(east, north))),
            foundation::degreesOf(std::asin(std::fmin(1.0, std::fmax(-1.0, sinElevation))))};
}

} // namespace simulation
