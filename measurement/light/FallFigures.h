// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "measurement/light/LightFigure.h"
#include "simulation/environment/Hydrometeors.h"
#include "simulation/environment/SurfaceWeather.h"

namespace measurement
{

/// What is measured of what falls and what it leaves.
struct FallParts
{
    std::function<simulation::Hydrometeors(double mmPerHour)> rain = simulation::rainOf,
                                                              snow = simulation::snowOf;
    std::function<double(double clearM, const simulation::Hydrometeors&)> visibilityM =
        simulation::visibilityM;
    std::function<double(double waterMm)> wetness = simulation::wetnessOf;
};

/// Sweeps rain, snow and water on the ground in 200 steps: counts those that go the wrong way.
LightFigures fallFigures(const FallParts& parts = {});

} // namespace measurement
