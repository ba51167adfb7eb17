// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/WeatheredGround.h"

namespace simulation
{

GroundWeather groundWeatherOf(const EnvironmentState& environment)
{
    const bool rains = environment.precipitation && environment.precipitation->type == "rain" &&
                       environment.precipitation->intensity.value_or(1.0) > 0.0;
    const bool isDry = environment.roadWetness == "dry" && !rains;
    return {environment.roadFriction, !isDry && environment.roadFriction >= 1.0};
}

void WeatheredGround::change(std::span<GroundPoint> answers) const
{
    for (GroundPoint& answer : answers)
    {
        if (answer.kind != GroundKind::asphalt) continue;
        if (_weather.isWet) answer.kind = GroundKind::wetAsphalt;
        answer.gripScale *= _weather.asphaltScale;
    }
}

} // namespace simulation
