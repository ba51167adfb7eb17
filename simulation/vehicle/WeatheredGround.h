// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <utility>

#include "simulation/state/EnvironmentState.h"
#include "simulation/vehicle/Ground.h"

namespace simulation
{

/// How the weather of a scenario changes the ground under tyres.
struct GroundWeather
{
    double asphaltScale = 1.0; ///< of the friction of asphalt (frictionScaleFactor)
    bool isWet = false;        ///< asphalt is wet
    bool isSnowy = false;      ///< snow lies on the ground, and on roads unless they are cleared
    bool isIcy = false;        ///< the water on asphalt is frozen
    bool areRoadsCleared = false;

    bool operator==(const GroundWeather&) const = default;
};

/// Returns it of an environment. A friction that the scenario gives below 1 stands for everything; water,
/// snow and ice then count no second time.
GroundWeather groundWeatherOf(const EnvironmentState& environment);

/// A ground as a weather leaves it: asphalt is wet, icy, under snow, or as rough as the scenario says; gravel
/// and grass are as before, or under snow. Water carries nothing still.
class WeatheredGround final : public Ground
{
public:
    WeatheredGround(std::shared_ptr<const Ground> ground, const GroundWeather& weather)
        : _ground(std::move(ground)), _weather(weather)
    {
    }

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        _ground->below(points, answers);
        change(answers);
    }

    void heightsBelow(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        _ground->heightsBelow(points, answers);
        change(answers);
    }

private:
    void change(std::span<GroundPoint> answers) const;

    std::shared_ptr<const Ground> _ground;
    GroundWeather _weather;
};

} // namespace simulation
