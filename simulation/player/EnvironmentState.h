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

/// The sky and the air at one instant.
struct EnvironmentState
{
    DateTime dateTime;
    SunDirection sun; ///< at the scene's origin; its azimuth is clockwise from north
    std::optional<double> fogVisualRangeM;
    std::string cloudState; ///< as the scenario wrote it; empty: nothing said
    std::optional<Precipitation> precipitation;
    std::optional<Wind> wind;
    std::optional<double> temperatureK, pressurePa; ///< of the air at the origin
    double roadFriction = 1.0;                      ///< of dry asphalt
    std::string roadWetness = "dry";                ///< in the standard's words
};

/// The environment as the actions so far have set it, and as it changes during the day. An action changes
/// only what it contains. The sun follows from date, time and position until an action gives its direction;
/// an action with a time of day and without a sun ends this. A scene without georeference uses the sun of 45°
/// N, 0° E.
/// Initial state: 2024-06-21T10:00:00Z, the time of day does not advance, no fog.
class EnvironmentClock
{
public:
    explicit EnvironmentClock(const std::optional<Geodetic>& origin);

    void apply(const Environment& environment, double timeS);
    EnvironmentState at(double timeS) const;
    double roadFriction() const { return _state.roadFriction; }

private:
    Geodetic _place;
    EnvironmentState _state;
    std::optional<SunDirection> _givenSun;
    bool _isAnimated = false;
    double _setAtS = 0.0;
};

} // namespace simulation
