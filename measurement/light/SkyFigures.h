// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <vector>

#include <glm/mat3x3.hpp>

#include "measurement/light/LightFigure.h"
#include "simulation/environment/BrightStars.h"
#include "simulation/environment/NightSky.h"
#include "simulation/environment/SunPosition.h"

namespace measurement
{

/// What is measured of sun, moon and stars: the functions that place them in the picture, or others.
struct SkyParts
{
    std::function<simulation::SunDirection(const simulation::DateTime&, double latitudeDeg,
                                           double longitudeDeg)>
        sun = simulation::sunDirection;
    std::function<simulation::MoonSight(const simulation::DateTime&, double latitudeDeg, double longitudeDeg)>
        moon = simulation::moonSight;
    std::function<glm::dmat3(const simulation::DateTime&, double latitudeDeg, double longitudeDeg)>
        worldFromStars = simulation::worldFromStars;
    std::function<std::vector<simulation::BrightStar>()> stars = simulation::brightStars;
    /// The faintest star that is seen, in magnitudes, by the height of the sun and moonlight. Absent: it is
    /// not measured.
    std::function<double(double sunElevationDeg, double moonlight)> faintestSeen{};
};

/// Measures where sun, moon and stars stand against two oracles, the moon's phase, when the sun rises and
/// sets against an almanac, and how fast stars come out. Cost: some 10 ms.
LightFigures skyFigures(const SkyParts& parts = {});

} // namespace measurement
