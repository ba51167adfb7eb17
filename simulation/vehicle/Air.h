// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/glm.hpp>

namespace simulation
{

/// The air at one place and time.
/// Units: SI. Frame of the wind: the scene's east-north-up, the direction in which the air moves.
struct AirSample
{
    double densityKgPerM3 = 1.225;
    double pressurePa = 101325.0;
    double temperatureK = 288.15;
    glm::dvec3 windMps{0.0};

    /// Turbulence: the wind 6 m above the ground that stirs the air near it, and the standard deviation of
    /// gusts above 600 m.
    double windAtSixMetresMps = 0.0;
    double gustDeviationMps = 0.0;
};

/// The air as vehicles and haze ask for it. The same question must always have the same answer.
class Air
{
public:
    virtual ~Air() = default;

    /// `heightM`: above the ellipsoid, which stands for the sea; `position`: in the scene's frame; `timeS`:
    /// of the simulation.
    virtual AirSample at(const glm::dvec3& position, double heightM, double timeS) const = 0;
};

} // namespace simulation
