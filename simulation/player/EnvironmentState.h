// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "simulation/environment/DateTime.h"
#include "simulation/environment/SunPosition.h"
#include "simulation/geodesy/LocalFrame.h"
#include "simulation/scenario/Environment.h"

namespace simulation
{

/// Sky and air at one instant.
struct EnvironmentState
{
    DateTime dateTime;
    SunDirection sun; ///< at the scene's origin; its azimuth is clockwise from north
    std::optional<double> fogVisualRangeM;
    std::string cloudState; ///< as the scenario wrote it; empty: nothing said
    std::optional<Precipitation> precipitation;
    std::optional<Wind> wind;
};

/// Keeps the environment from action to action and through the day. What an action leaves out stays as it was.
/// The sun follows from date, time and place, until an action gives its direction; an action with a time of day and
/// no sun puts it under the date's rule again. Without a georeference the sun is that of 45° N, 0° E.
/// Before any action: 2024-06-21T10:00:00Z, standing still; no fog.
class EnvironmentClock
{
public:
    explicit EnvironmentClock(const std::optional<Geodetic>& origin);

    void apply(const Environment& environment, double timeS);
    EnvironmentState at(double timeS) const;

private:
    Geodetic _place;
    EnvironmentState _state;
    std::optional<SunDirection> _givenSun;
    bool _isAnimated = false;
    double _setAtS = 0.0;
};

} // namespace simulation
