// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/AttitudeHold.h"

#include <algorithm>
#include <cmath>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{
namespace
{

constexpr double kReferenceMps = 40.0; ///< at which the gains are as below
constexpr double kPitchGain = 2.5, kPitchRateGain = 0.8, kPitchIntegralGain = 1.5;
constexpr double kRollGain = 1.6, kRollRateGain = 0.35, kRollIntegralGain = 0.5;
constexpr double kFarthestAileron = 0.3;
constexpr double kSideslipGain = 1.2, kYawRateGain = 0.6;
constexpr double kFarthestElevator = 0.9;

} // namespace

SurfaceInputs AttitudeHold::step(const FlightSense& sense, double pitch, double roll, double stepS)
{
    const double speed = std::max(sense.calibratedAirspeedMps, 15.0);
    const double gain = std::clamp(kReferenceMps * kReferenceMps / (speed * speed), 0.3, 3.0);
    const double pitchError = std::clamp(pitch - sense.pitch, -0.3, 0.3);
    _elevator = std::clamp(_elevator - gain * kPitchIntegralGain * pitchError * stepS, -kFarthestElevator,
                           kFarthestElevator);
    // In a turn the nose must rise and turn with it: rates of a steady turn are not damped.
    const double turnRate =
        foundation::kStandardGravityMps2 * std::tan(std::clamp(sense.roll, -1.0, 1.0)) / speed;
    const double turnPitchRate = turnRate * std::sin(sense.roll) * std::cos(sense.pitch);
    const double turnYawRate = turnRate * std::cos(sense.roll) * std::cos(sense.pitch);
    SurfaceInputs inputs;
    inputs.elevator = std::clamp(
        _elevator - gain * (kPitchGain * pitchError - kPitchRateGain * (sense.pitchRate - turnPitchRate)),
        -1.0, 1.0);
    _aileron = std::clamp(_aileron + kRollIntegralGain * std::clamp(roll - sense.roll, -0.1, 0.1) * stepS,
                          -kFarthestAileron, kFarthestAileron);
    inputs.aileron = std::clamp(
        _aileron + gain * (kRollGain * (roll - sense.roll) - kRollRateGain * sense.rollRate), -1.0, 1.0);
    inputs.rudder = std::clamp(
        gain * (-kSideslipGain * sense.sideslip + kYawRateGain * (sense.yawRate - turnYawRate)), -1.0, 1.0);
    return inputs;
}

} // namespace simulation
