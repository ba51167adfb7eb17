// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/RunwayFlight.h"

namespace simulation
{
namespace
{

constexpr double kRotateMps = 28.0; ///< 55 kt
constexpr double kRotatePitch = 0.13;
constexpr double kClimbMps = 38.0; ///< 74 kt
constexpr double kSettledM = 10.0; ///< wheels above the ground
constexpr double kEndM = 150.0;
constexpr double kLevelBank = 0.26, kLiftOffBank = 0.08;

} // namespace

FlightCommand TakeOff::step(const FlightSense& sense, double stepS)
{
    const CourseLine line = _runway.centreLine();
    FlightCommand command;
    command.throttle = 1.0;
    _isRotating = _isRotating || sense.calibratedAirspeedMps > kRotateMps;
    if (!_isRotating)
    {
        command.surfaces = {0.0, aileronIntoWind(sense, line), _steering.step(sense, line, stepS)};
        return command;
    }
    if (!_isUp && sense.wheelHeightM > kSettledM)
    {
        _isUp = true;
        _phase = "climb-out";
        _climb.reset(sense, 1.0);
    }
    const double pitch = _isUp ? _climb.holdSpeed(sense, 1.0, kClimbMps, stepS).pitch : kRotatePitch;
    const double bank = bankToLine(sense, line, _isUp ? kLevelBank : kLiftOffBank);
    command.surfaces = _attitude.step(sense, pitch, bank, stepS);
    if (sense.isOnGround) command.surfaces.rudder = _steering.step(sense, line, stepS);
    if (sense.isOnGround) command.surfaces.aileron = aileronIntoWind(sense, line);
    _isDone = sense.position.z - _runway.threshold.z > kEndM;
    return command;
}

} // namespace simulation
