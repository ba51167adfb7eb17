// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/WeatheredGround.h"

namespace simulation
{

GroundWeather groundWeatherOf(const EnvironmentState& environment)
{
    const auto falls = [&](const char* type)
    {
        return environment.precipitation && environment.precipitation->type == type &&
               environment.precipitation->intensity.value_or(1.0) > 0.0;
    };
    const bool isDry = environment.roadWetness == "dry" && !falls("rain");
    const bool isGiven = environment.roadFriction < 1.0;
    return {environment.roadFriction, !isDry && !isGiven, falls("snow") && !isGiven};
}

void WeatheredGround::change(std::span<GroundPoint> answers) const
{
    for (GroundPoint& answer : answers)
    {
        if (answer.kind != GroundKind::asphalt) continue;
        if (_weather.isWet) answer.kind = GroundKind::wetAsphalt;
        if (_weather.isSnowy) answer.kind = GroundKind::snow;
        answer.gripScale *= _weather.asphaltScale;
    }
}

} // namespace simulation
