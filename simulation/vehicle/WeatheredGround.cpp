// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/WeatheredGround.h"

namespace simulation
{

GroundWeather groundWeatherOf(const EnvironmentState& environment)
{
    const SurfaceWeather& surface = environment.surface;
    const bool isGiven = environment.roadFriction < 1.0;
    const bool isWet = surface.waterMm >= kLeastFilmMm && !isGiven;
    return {environment.roadFriction, isWet && !surface.isIcy, surface.snowCm >= kLeastSnowCm && !isGiven,
            isWet && surface.isIcy, surface.areRoadsCleared};
}

void WeatheredGround::change(std::span<GroundPoint> answers) const
{
    for (GroundPoint& answer : answers)
    {
        const bool isRoad = answer.kind == GroundKind::asphalt;
        if (isRoad && _weather.isWet) answer.kind = GroundKind::wetAsphalt;
        if (isRoad && _weather.isIcy) answer.kind = GroundKind::ice;
        const bool takesSnow =
            isRoad || answer.kind == GroundKind::gravel || answer.kind == GroundKind::grass;
        if (_weather.isSnowy && takesSnow && !(isRoad && _weather.areRoadsCleared))
            answer.kind = GroundKind::snow;
        if (isRoad) answer.gripScale *= _weather.asphaltScale;
    }
}

} // namespace simulation
