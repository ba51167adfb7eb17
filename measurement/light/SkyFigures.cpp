// SPDX-License-Identifier: Apache-2.0
#include "measurement/light/SkyFigures.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>

#include "measurement/light/KnownSky.h"

namespace measurement
{

using simulation::DateTime;

namespace
{

glm::dvec3 directionOf(const SeenAt& seen)
{
    const double azimuth = foundation::radiansOf(seen.azimuthDeg),
                 elevation = foundation::radiansOf(seen.elevationDeg);
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

double apartDeg(const glm::dvec3& a, const glm::dvec3& b)
{
    return foundation::degreesOf(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

/// The instant of a table of this project; 1970 where it is none, which no figure stands.
DateTime instantOf(const char* text)
{
    return simulation::parseDateTime(text).value_or(DateTime{});
}

struct WorstLights
{
    double sunDeg = 0.0, moonDeg = 0.0, phase = 0.0;
};

WorstLights worstLights(const SkyParts& parts)
{
    WorstLights worst;
    for (const KnownInstant& known : knownInstants())
    {
        const DateTime at = instantOf(known.time);
        const simulation::SunDirection sun = parts.sun(at, known.latitudeDeg, known.longitudeDeg);
        const simulation::MoonSight moon = parts.moon(at, known.latitudeDeg, known.longitudeDeg);
        for (const KnownLights* oracle : {&known.pyEphem, &known.erfa})
        {
            worst.sunDeg = std::max(worst.sunDeg, apartDeg(directionOf({sun.azimuthDeg, sun.elevationDeg}),
                                                           directionOf(oracle->sun)));
            worst.moonDeg = std::max(worst.moonDeg, apartDeg(moon.towards, directionOf(oracle->moon)));
            worst.phase = std::max(worst.phase, std::abs(moon.litShare - oracle->litShare));
        }
    }
    return worst;
}

/// How far the worst of the known stars is from the nearest bright one that is drawn.
double worstStarDeg(const SkyParts& parts, const KnownStars& known)
{
    const glm::dmat3 turn =
        parts.worldFromStars(instantOf(known.time), known.latitudeDeg, known.longitudeDeg);
    const std::vector<simulation::BrightStar> stars = parts.stars();
    double worst = 0.0;
    for (const SeenAt& seen : known.stars)
    {
        double nearest = 180.0;
        for (const simulation::BrightStar& star : stars)
        {
            if (star.magnitude > 2.5) continue;
            const glm::dvec3 fixed = directionOf({90.0 - star.rightAscensionDeg, star.declinationDeg});
            nearest = std::min(nearest, apartDeg(turn * fixed, directionOf(seen)));
        }
        worst = std::max(worst, nearest);
    }
    return worst;
}

/// How many seconds the upper edge of the drawn sun crosses the horizon before or after the almanac says so,
/// at the most. Not found within ten minutes: no number.
double worstSunriseS(const SkyParts& parts)
{
    constexpr double kRadiusDeg = 0.2666, kSearchS = 600.0, kStepS = 1.0;
    double worst = 0.0;
    for (const KnownSunrise& known : knownSunrises())
    {
        const DateTime at = instantOf(known.time);
        const auto isUp = [&](double seconds)
        {
            return parts.sun(at.plusSeconds(seconds), known.latitudeDeg, known.longitudeDeg).elevationDeg >
                   -kRadiusDeg;
        };
        double seconds = -kSearchS;
        while (seconds < kSearchS && isUp(seconds) != known.isRise)
            seconds += kStepS;
        if (seconds <= -kSearchS || seconds >= kSearchS) return std::nan("");
        worst = std::max(worst, std::abs(seconds));
    }
    return worst;
}

/// The most by which the faintest star changes in a minute of two months of nights at the equator, where
/// dusk is shortest; magnitudes.
double fastestStars(const SkyParts& parts)
{
    constexpr double kLatitudeDeg = 0.0, kLongitudeDeg = 37.0, kMinuteS = 60.0;
    constexpr int kDays = 59, kHoursOfNight = 13;
    double fastest = 0.0;
    for (int day = 0; day < kDays; day += 4)
    {
        const DateTime dusk = instantOf("2024-03-01T15:00:00Z").plusSeconds(86400.0 * day);
        double before = 0.0;
        for (int minute = 0; minute < 60 * kHoursOfNight; ++minute)
        {
            const DateTime at = dusk.plusSeconds(kMinuteS * minute);
            const double sunDeg = parts.sun(at, kLatitudeDeg, kLongitudeDeg).elevationDeg;
            const double moonlight = simulation::moonlightOf(parts.moon(at, kLatitudeDeg, kLongitudeDeg));
            const double now = parts.faintestSeen(sunDeg, moonlight);
            if (minute > 0) fastest = std::max(fastest, std::abs(now - before));
            before = now;
        }
    }
    return fastest;
}

} // namespace

LightFigures skyFigures(const SkyParts& parts)
{
    const char* const kOracles = "PyEphem 4.1.4 and ERFA 2.0.0";
    const WorstLights worst = worstLights(parts);
    LightFigures figures{
        atMost("N8", "sun: direction, worst of 20 from 1950 to 2049", worst.sunDeg, "deg", 0.01, kOracles),
        atMost("N8", "moon: direction, worst of the same", worst.moonDeg, "deg", 0.03, kOracles),
        atMost("N8", "moon: phase, worst of the same", 100.0 * worst.phase, "%", 1.0, kOracles)};
    for (const KnownStars& known : knownStars())
        figures.push_back(atMost("N8", "stars: direction, worst of ten in " + std::string(known.time, 4),
                                 worstStarDeg(parts, known), "deg", 0.02, "PyEphem 4.1.4"));
    figures.push_back(atMost("N8", "sun: rise and set, worst of twelve", worstSunriseS(parts), "s", 30.0,
                             "PyEphem 4.1.4, almanac with 34' of refraction"));
    if (parts.faintestSeen)
        figures.push_back(atMost("N8", "stars: faintest seen, fastest change at the equator",
                                 fastestStars(parts), "mag/min", 0.05, "goal of this project"));
    return figures;
}

} // namespace measurement
