// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/FlightGuidance.h"

#include <algorithm>
#include <cmath>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{
namespace
{

constexpr double kTurnTimeS = 2.5;    ///< in which a small error of the track is turned away
constexpr double kLineLeadM = 150.0;  ///< the wanted track leans by 45° that far from the line
constexpr double kSteepestLean = 0.9; ///< of the wanted track towards the line
constexpr double kThrottleGain = 0.06, kThrottleIntegralGain = 0.02, kThrottleRateGain = 0.10;
constexpr double kAttackTimeS = 2.0;
constexpr double kAltitudeTimeS = 5.0;
constexpr double kMostPitch = 0.26, kLeastPitch = -0.20;

} // namespace

glm::dvec2 CourseLine::along() const
{
    return {std::sin(course), std::cos(course)};
}

double CourseLine::besideM(const glm::dvec3& place) const
{
    const glm::dvec2 way = glm::dvec2(place) - point, forward = along();
    return way.x * forward.y - way.y * forward.x;
}

double CourseLine::alongM(const glm::dvec3& place) const
{
    return glm::dot(glm::dvec2(place) - point, along());
}

double bankToHeading(const FlightSense& sense, double heading, double mostBank)
{
    // The wind's drift is part of neither: to a heading by the heading.
    const double rate = halfTurn(heading - sense.heading) / kTurnTimeS;
    const double speed = std::max(sense.trueAirspeedMps, 15.0);
    return std::clamp(std::atan(rate * speed / foundation::kStandardGravityMps2), -mostBank, mostBank);
}

double bankToLine(const FlightSense& sense, const CourseLine& line, double mostBank)
{
    const double lean = std::atan(line.besideM(sense.position) / kLineLeadM);
    const double track = line.course - std::clamp(lean, -kSteepestLean, kSteepestLean);
    const double rate = halfTurn(track - sense.track) / kTurnTimeS;
    return std::clamp(std::atan(rate * sense.groundSpeedMps / foundation::kStandardGravityMps2), -mostBank,
                      mostBank);
}

double SpeedAndClimb::speedRate(double speedMps, double stepS)
{
    const double rate = _hasLastSpeed ? (speedMps - _lastSpeedMps) / stepS : 0.0;
    _lastSpeedMps = speedMps;
    _hasLastSpeed = true;
    return rate;
}

PowerAndPitch SpeedAndClimb::holdClimb(const FlightSense& sense, double speedMps, double climbMps,
                                       double stepS)
{
    const double speed = sense.calibratedAirspeedMps;
    const double rate = speedRate(speed, stepS);
    const double error = std::clamp(speedMps - speed, -5.0, 5.0);
    _throttle = std::clamp(_throttle + kThrottleIntegralGain * error * stepS, 0.0, 1.0);
    const double throttle = std::clamp(
        _throttle + kThrottleGain * error - kThrottleRateGain * std::clamp(rate, -2.0, 2.0), 0.0, 1.0);
    const double trueSpeed = std::max(sense.trueAirspeedMps, 15.0);
    const double path = std::asin(std::clamp(climbMps / trueSpeed, -0.3, 0.3));
    _attack += (sense.pitch - sense.pathAngle - _attack) * std::min(1.0, stepS / kAttackTimeS);
    const double pitch = path + _attack + 0.5 * (path - sense.pathAngle);
    return {throttle, std::clamp(pitch, kLeastPitch, kMostPitch)};
}

PowerAndPitch SpeedAndClimb::holdSpeed(const FlightSense& sense, double throttle, double speedMps,
                                       double stepS)
{
    const double speed = sense.calibratedAirspeedMps;
    const double rate = speedRate(speed, stepS);
    const double error = std::clamp(speed - speedMps, -8.0, 8.0);
    _climbPitch = std::clamp(_climbPitch + 0.004 * error * stepS, kLeastPitch, kMostPitch);
    _throttle = throttle;
    _attack += (sense.pitch - sense.pathAngle - _attack) * std::min(1.0, stepS / kAttackTimeS);
    return {throttle, std::clamp(_climbPitch + 0.02 * error + 0.05 * std::clamp(rate, -2.0, 2.0), kLeastPitch,
                                 kMostPitch)};
}

void SpeedAndClimb::reset(const FlightSense& sense, double throttle)
{
    _throttle = throttle;
    _attack = sense.pitch - sense.pathAngle;
    _climbPitch = sense.pitch;
    _hasLastSpeed = false;
}

double climbToAltitude(double altitudeM, double wantedM, double mostMps)
{
    return std::clamp((wantedM - altitudeM) / kAltitudeTimeS, -mostMps, mostMps);
}

} // namespace simulation
