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
    std::optional<double> seaPressurePa;            ///< in place of pressurePa: reduced to the sea (QNH)
    double roadFriction = 1.0;                      ///< of dry asphalt
    std::string roadWetness = "dry";                ///< in the standard's words
    /// what lies on the ground, by all that was told and fell
    SurfaceWeather surface;
};

/// Whether lamps burn: those of vehicles, instruments and what stands in the scene. From 3° of the sun above
/// the horizon down, when drivers switch their head lamps on.
bool isDark(const EnvironmentState& environment);

/// What a world says of its own air; absent: nothing.
struct WorldAir
{
    std::optional<SunDirection> sun;
    std::optional<double> visibilityM;
    std::optional<SurfaceWeather> ground{};
};

/// The environment as the actions so far have set it, and as it changes during the day. An action changes
/// only what it contains. The sun follows from date, time and position until an action gives its direction;
/// an action with a time of day and without a sun ends this. A scene without georeference uses the sun of 45°
/// N, 0° E.
/// Initial state: 10 o'clock of 21 June 2024 by whole hours of longitude (UTC within 15° of Greenwich) and
/// the sun of that time, or the world's own sun; the world's own visibility; the time of day does not
/// advance.
/// The ground begins as the scenario tells, else as the world does; where neither tells, what falls at the
/// begin has fallen for an hour. From then on it follows what falls (weathered()). A wetness of the road that
/// an action tells holds until another one does, and rain may leave more.
class EnvironmentClock
{
public:
    /// `world`: what the world says of its air, until an action says otherwise.
    explicit EnvironmentClock(const std::optional<Geodetic>& origin, const WorldAir& world = {});

    void apply(const Environment& environment, double timeS);
    EnvironmentState at(double timeS) const;
    double roadFriction() const { return _state.roadFriction; }

private:
    void takeOver(const Environment& environment, double timeS);
    Fall fallNow() const;
    SurfaceWeather groundAt(double timeS) const;

    Geodetic _place;
    EnvironmentState _state;
    std::optional<SurfaceWeather> _toldGround; ///< by the world, or by an action at the begin
    SurfaceWeather _ground;                    ///< at _groundAtS, without the told wetness of roads
    double _groundAtS = 0.0;
    std::optional<SunDirection> _givenSun;
    bool _isAnimated = false;
    double _setAtS = 0.0;
};

} // namespace simulation
