// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "simulation/control/flight/AttitudeHold.h"
#include "simulation/control/flight/GroundSteering.h"

namespace simulation
{

/// All inputs that an autopilot sets.
struct FlightCommand
{
    SurfaceInputs surfaces;
    double throttle = 0.0;
    double flaps = 0.0;
    double brakes = 0.0;
};

/// Takes off: full power, along the centre line by pedals, rotation, climb straight ahead.
class TakeOff
{
public:
    explicit TakeOff(const RunwayStrip& runway) : _runway(runway) {}

    FlightCommand step(const FlightSense& sense, double stepS);
    bool isDone() const { return _isDone; }
    std::string_view phase() const { return _phase; }

private:
    RunwayStrip _runway;
    GroundSteering _steering;
    AttitudeHold _attitude;
    SpeedAndClimb _climb;
    std::string_view _phase = "take-off";
    bool _isRotating = false, _isUp = false, _isDone = false;
};

/// Lands: onto the centre line, down the glide path, the nose straight and one wing low against the wind,
/// flare, roll-out, stop.
/// Source: Federal Aviation Administration, *Airplane Flying Handbook* (FAA-H-8083-3C), 2021, chapter 9
/// (approaches and landings: crosswind by sideslip, round out, after-landing roll).
class Landing
{
public:
    explicit Landing(const RunwayStrip& runway) : _runway(runway) {}

    /// Begins from what is flown now.
    void begin(const FlightSense& sense, double throttle, double elevator);

    FlightCommand step(const FlightSense& sense, double stepS);
    bool isDone() const { return _isDone; }
    std::string_view phase() const { return _phase; }

private:
    FlightCommand approach(const FlightSense& sense, double stepS);
    FlightCommand rollOut(const FlightSense& sense, double stepS);
    SurfaceInputs slip(const FlightSense& sense, double pitch, double stepS);

    RunwayStrip _runway;
    GroundSteering _steering;
    AttitudeHold _attitude;
    SpeedAndClimb _climb;
    std::string_view _phase = "final";
    double _straightRudder = 0.0; ///< the integral part of the nose along the runway
    double _straight = 0.0;       ///< 0 crabbing … 1 along the runway
    double _flareThrottle = 0.0;
    double _elevator = 0.0, _rudder = 0.0, _rolledS = 0.0; ///< of the roll-out
    bool _isFlaring = false, _isDown = false, _isDone = false;
};

} // namespace simulation
