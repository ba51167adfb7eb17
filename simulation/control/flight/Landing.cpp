// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "simulation/control/flight/RunwayFlight.h"

namespace simulation
{
namespace
{

constexpr double kGlidePath = 0.0524; ///< 3°
constexpr double kAimM = 150.0;       ///< beyond the threshold
constexpr double kFinalMps = 31.5;    ///< 61 kt
constexpr double kStraightenS = 3.0;
constexpr double kStraightFinalM =
    15.0; ///< wheels above the ground: from here on the nose is along the runway
constexpr double kFlareM = 5.0;
constexpr double kFlareRate = 0.38; ///< of the height, each second
constexpr double kTouchdownMps = 0.5;
constexpr double kLineBank = 0.30, kLowBank = 0.14;
constexpr double kSlipBank = 0.5;    ///< for each radian of sideslip
constexpr double kSlipAileron = 1.3; ///< against the dihedral
constexpr double kSlipRudder = 4.0;  ///< against the weathercock
constexpr double kStraightGain = 2.5, kStraightRateGain = 1.2, kStraightIntegralGain = 0.8;
constexpr double kLowerNoseS = 0.7; ///< in which the elevator is let go after touchdown
constexpr double kKeptPedals = 0.2; ///< share of the pedals of the last moment in the air
constexpr double kStickBack = -0.1; ///< loads the main wheels
constexpr double kBrakeMps = 27.0,
                 kBrakes = 0.35;        ///< the wind across is taken off that speed: it lifts a wing
constexpr double kStraightEnough = 0.1; ///< of the heading, for brakes
constexpr double kStoppedMps = 0.05;

} // namespace

void Landing::begin(const FlightSense& sense, double throttle, double elevator)
{
    _climb.reset(sense, throttle);
    _attitude.reset(elevator);
}

FlightCommand Landing::step(const FlightSense& sense, double stepS)
{
    if (!_isDown && sense.isOnGround && _isFlaring)
    {
        _isDown = true;
        _phase = "roll-out";
        _steering.reset(kKeptPedals * _rudder);
    }
    return _isDown ? rollOut(sense, stepS) : approach(sense, stepS);
}

/// The nose along the runway by the rudder, one wing low against the wind. Both are led by what the wind
/// across the runway asks for: the sideslip itself would take away the aircraft's own stability.
SurfaceInputs Landing::slip(const FlightSense& sense, double pitch, double stepS)
{
    const double fromRightMps = windFromRightMps(sense, _runway.centreLine());
    const double sideslip = std::atan2(fromRightMps, std::max(sense.groundSpeedMps, kFinalMps / 2.0));
    _straight = std::min(1.0, _straight + stepS / kStraightenS);
    const double crab = (1.0 - _straight) * sideslip;
    const double bank = bankToLine(sense, _runway.centreLine(), kLowBank) + _straight * kSlipBank * sideslip;
    SurfaceInputs surfaces = _attitude.step(sense, pitch, bank, stepS);
    surfaces.aileron = std::clamp(surfaces.aileron + _straight * kSlipAileron * sideslip, -1.0, 1.0);
    const double error = halfTurn(_runway.course + crab - sense.heading);
    _straightRudder = std::clamp(_straightRudder - kStraightIntegralGain * error * stepS, -0.3, 0.3);
    surfaces.rudder = std::clamp(_straightRudder - kStraightGain * error + kStraightRateGain * sense.yawRate +
                                     _straight * kSlipRudder * sideslip,
                                 -1.0, 1.0);
    return surfaces;
}

FlightCommand Landing::approach(const FlightSense& sense, double stepS)
{
    const CourseLine line = _runway.centreLine();
    FlightCommand command;
    command.flaps = 1.0;
    const double pathM = _runway.threshold.z + (kAimM - line.alongM(sense.position)) * std::tan(kGlidePath);
    const double wheelsM = sense.wheelHeightM;
    const double bodyM = sense.position.z - pathM;
    double climb = std::clamp(-sense.groundSpeedMps * std::tan(kGlidePath) - 0.25 * bodyM, -4.5, 0.0);
    if (!_isFlaring && wheelsM < kFlareM)
    {
        _isFlaring = true;
        _phase = "flare";
    }
    if (_isFlaring) climb = -std::max(kTouchdownMps, kFlareRate * wheelsM);
    const PowerAndPitch hold = _climb.holdClimb(sense, kFinalMps, climb, stepS);
    if (!_isFlaring) _flareThrottle = hold.throttle;
    command.throttle =
        _isFlaring ? _flareThrottle * std::clamp(wheelsM / kFlareM - 0.2, 0.0, 1.0) : hold.throttle;
    command.surfaces = wheelsM < kStraightFinalM
                           ? slip(sense, hold.pitch, stepS)
                           : _attitude.step(sense, hold.pitch, bankToLine(sense, line, kLineBank), stepS);
    _elevator = command.surfaces.elevator;
    _rudder = command.surfaces.rudder;
    return command;
}

/// While the nose comes down the rudder holds it straight as in the air; then the nose wheel steers.
FlightCommand Landing::rollOut(const FlightSense& sense, double stepS)
{
    const CourseLine line = _runway.centreLine();
    FlightCommand command;
    _elevator += (kStickBack - _elevator) * (1.0 - std::exp(-stepS / kLowerNoseS));
    _rolledS += stepS;
    const double onWheels = std::clamp(_rolledS / kLowerNoseS - 1.0, 0.0, 1.0);
    command.surfaces.rudder =
        glm::mix(slip(sense, sense.pitch, stepS).rudder, _steering.step(sense, line, stepS), onWheels);
    command.surfaces.elevator = _elevator;
    command.surfaces.aileron = aileronIntoWind(sense, line);
    const bool isStraight = std::abs(halfTurn(sense.heading - line.course)) < kStraightEnough;
    const double brakeMps = kBrakeMps - std::abs(windFromRightMps(sense, line));
    command.brakes = onWheels < 1.0 || !isStraight || sense.groundSpeedMps > brakeMps ? 0.0 : kBrakes;
    if (sense.groundSpeedMps < kStoppedMps && !_isDone)
    {
        _isDone = true;
        _phase = "stopped";
    }
    return command;
}

} // namespace simulation
