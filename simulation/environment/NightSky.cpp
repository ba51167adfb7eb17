// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/NightSky.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "simulation/environment/SunPosition.h"

namespace simulation
{
namespace
{

constexpr double kEarthRadiusKm = 6378.14, kDynamicalMinusUniversalDays = 69.0 / 86400.0;

double sinOf(double angleDeg)
{
    return std::sin(foundation::radiansOf(angleDeg));
}
double cosOf(double angleDeg)
{
    return std::cos(foundation::radiansOf(angleDeg));
}

double centuriesOf(double julianDay)
{
    return (julianDay - 2451545.0) / 36525.0;
}

/// From directions of the equator of date to east, north, up.
glm::dmat3 worldFromEquator(double julianDay, double latitudeDeg, double longitudeDeg)
{
    const double sidereal = greenwichSiderealDeg(julianDay) + longitudeDeg;
    const glm::dvec3 east(-sinOf(sidereal), cosOf(sidereal), 0.0);
    const glm::dvec3 up(cosOf(latitudeDeg) * cosOf(sidereal), cosOf(latitudeDeg) * sinOf(sidereal),
                        sinOf(latitudeDeg));
    return glm::transpose(glm::dmat3(east, glm::cross(up, east), up));
}

/// A periodic term: multiples of D, M, M' and F, and its strength.
struct Term
{
    int elongation, sunAnomaly, anomaly, latitude;
    double strength;
};

constexpr std::array<Term, 27> kLongitude{{
    {0, 0, 1, 0, 6.288774},  {2, 0, -1, 0, 1.274027},  {2, 0, 0, 0, 0.658314},   {0, 0, 2, 0, 0.213618},
    {0, 1, 0, 0, -0.185116}, {0, 0, 0, 2, -0.114332},  {2, 0, -2, 0, 0.058793},  {2, -1, -1, 0, 0.057066},
    {2, 0, 1, 0, 0.053322},  {2, -1, 0, 0, 0.045758},  {0, 1, -1, 0, -0.040923}, {1, 0, 0, 0, -0.034720},
    {0, 1, 1, 0, -0.030383}, {2, 0, 0, -2, 0.015327},  {0, 0, 1, 2, -0.012528},  {0, 0, 1, -2, 0.010980},
    {4, 0, -1, 0, 0.010675}, {0, 0, 3, 0, 0.010034},   {4, 0, -2, 0, 0.008548},  {2, 1, -1, 0, -0.007888},
    {2, 1, 0, 0, -0.006766}, {1, 0, -1, 0, -0.005163}, {1, 1, 0, 0, 0.004987},   {2, -1, 1, 0, 0.004036},
    {2, 0, 2, 0, 0.003994},  {4, 0, 0, 0, 0.003861},   {2, 0, -3, 0, 0.003665},
}};
constexpr std::array<Term, 13> kLatitude{{
    {0, 0, 0, 1, 5.128122},
    {0, 0, 1, 1, 0.280602},
    {0, 0, 1, -1, 0.277693},
    {2, 0, 0, -1, 0.173237},
    {2, 0, -1, 1, 0.055413},
    {2, 0, -1, -1, 0.046271},
    {2, 0, 0, 1, 0.032573},
    {0, 0, 2, 1, 0.017198},
    {2, 0, 1, -1, 0.009266},
    {0, 0, 2, -1, 0.008822},
    {2, -1, 0, -1, 0.008216},
    {2, 0, -2, -1, 0.004324},
    {2, 0, 1, 1, 0.004200},
}};
constexpr std::array<Term, 8> kDistanceKm{{
    {0, 0, 1, 0, -20905.355},
    {2, 0, -1, 0, -3699.111},
    {2, 0, 0, 0, -2955.968},
    {0, 0, 2, 0, -569.925},
    {0, 1, 0, 0, 48.888},
    {2, 0, -2, 0, 246.158},
    {2, -1, -1, 0, -152.138},
    {2, 0, 1, 0, -170.733},
}};

/// The arguments of the terms, degrees.
struct Arguments
{
    double elongation, sunAnomaly, anomaly, latitude;

    double of(const Term& term) const
    {
        return term.elongation * elongation + term.sunAnomaly * sunAnomaly + term.anomaly * anomaly +
               term.latitude * latitude;
    }
};

/// Place of the moon from the middle of the Earth, in kilometres, in the equator of date.
glm::dvec3 moonFromEarth(double t)
{
    const Arguments arguments{297.8501921 + 445267.1114034 * t, 357.5291092 + 35999.0502909 * t,
                              134.9633964 + 477198.8675055 * t, 93.2720950 + 483202.0175233 * t};
    const double eccentricity = 1.0 - 0.002516 * t;
    const auto weight = [&](const Term& term) { return term.sunAnomaly == 0 ? 1.0 : eccentricity; };
    double longitude = 218.3164477 + 481267.88123421 * t, latitude = 0.0, distance = 385000.56;
    for (const Term& term : kLongitude)
        longitude += weight(term) * term.strength * sinOf(arguments.of(term));
    for (const Term& term : kLatitude)
        latitude += weight(term) * term.strength * sinOf(arguments.of(term));
    for (const Term& term : kDistanceKm)
        distance += weight(term) * term.strength * cosOf(arguments.of(term));
    const double obliquity = 23.43929111 - 0.013004167 * t;
    const glm::dvec3 ecliptic(cosOf(latitude) * cosOf(longitude), cosOf(latitude) * sinOf(longitude),
                              sinOf(latitude));
    return distance * glm::dvec3(ecliptic.x, ecliptic.y * cosOf(obliquity) - ecliptic.z * sinOf(obliquity),
                                 ecliptic.y * sinOf(obliquity) + ecliptic.z * cosOf(obliquity));
}

} // namespace

glm::dmat3 worldFromStars(const DateTime& utc, double latitudeDeg, double longitudeDeg)
{
    const double day = utc.julianDay(), t = centuriesOf(day);
    const double zeta = t * (2306.2181 + t * 0.30188) / 3600.0, z = t * (2306.2181 + t * 1.09468) / 3600.0;
    const double theta = t * (2004.3109 - t * 0.42665) / 3600.0;
    const auto about3 = [](double angle)
    { return glm::dmat3(cosOf(angle), sinOf(angle), 0.0, -sinOf(angle), cosOf(angle), 0.0, 0.0, 0.0, 1.0); };
    const glm::dmat3 about2(cosOf(theta), 0.0, sinOf(theta), 0.0, 1.0, 0.0, -sinOf(theta), 0.0, cosOf(theta));
    return worldFromEquator(day, latitudeDeg, longitudeDeg) * about3(z) * about2 * about3(zeta);
}

MoonSight moonSight(const DateTime& utc, double latitudeDeg, double longitudeDeg)
{
    const double day = utc.julianDay(), ephemerisDay = day + kDynamicalMinusUniversalDays;
    const glm::dvec3 fromEarth = moonFromEarth(centuriesOf(ephemerisDay));
    MoonSight sight;
    sight.distanceKm = glm::length(fromEarth);
    const glm::dvec3 seen =
        worldFromEquator(day, latitudeDeg, longitudeDeg) * fromEarth - glm::dvec3(0.0, 0.0, kEarthRadiusKm);
    sight.towards = glm::normalize(seen);
    const SunEquatorial sun = sunEquatorial(ephemerisDay);
    const glm::dvec3 towardsSun(cosOf(sun.declinationDeg) * cosOf(sun.rightAscensionDeg),
                                cosOf(sun.declinationDeg) * sinOf(sun.rightAscensionDeg),
                                sinOf(sun.declinationDeg));
    sight.litShare = 0.5 - 0.5 * glm::dot(towardsSun, fromEarth / sight.distanceKm);
    return sight;
}

double moonlightOf(const MoonSight& moon)
{
    const double phaseDeg =
        foundation::degreesOf(std::acos(std::clamp(2.0 * moon.litShare - 1.0, -1.0, 1.0)));
    const double byPhase = std::pow(10.0, -0.4 * (0.026 * phaseDeg + 4e-9 * std::pow(phaseDeg, 4.0)));
    return byPhase * std::max(moon.towards.z, 0.0);
}

} // namespace simulation
