// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/Air.h"
#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

/// One gust: the wind rises to its peak and falls again as 1 - cos.
/// Source: MIL-F-8785C, *Flying Qualities of Piloted Airplanes*, 1980, section 3.7.2.3 (the discrete gust,
/// here over time).
struct Gust
{
    double startS = 0.0;
    double lengthS = 0.0; ///< from calm to calm; 0: no gust
    glm::dvec3 peakMps{0.0};
};

/// The weather of one day.
struct WeatherSettings
{
    AtmosphereOffsets offsets;
    glm::dvec3 windMps{0.0}; ///< scene's frame, the direction in which the air moves
    Gust gust;
    double windAtSixMetresMps = 0.0; ///< stirs the turbulence near the ground
    double gustDeviationMps = 0.0;   ///< of turbulence above 600 m
};

/// Air of a standard atmosphere with offsets, one wind, one gust, and turbulence of one strength.
class WeatherAir : public Air
{
public:
    explicit WeatherAir(const WeatherSettings& weather = {}) : _weather(weather) {}

    AirSample at(const glm::dvec3& position, double heightM, double timeS) const override;

private:
    WeatherSettings _weather;
};

} // namespace simulation
