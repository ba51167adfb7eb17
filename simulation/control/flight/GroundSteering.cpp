// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/GroundSteering.h"

#include <algorithm>
#include <cmath>

namespace simulation
{
namespace
{

constexpr double kLeadM = 40.0; ///< the heading leans by 45° that far from the line
constexpr double kMostLean = 0.06;
constexpr double kTurnPerS = 0.8; ///< of the heading's error
constexpr double kMostSidewaysMps2 = 1.2;
constexpr double kRateGainMps = 6.0,
                 kIntegralGainMps =
                     50.0; ///< over the speed: the nose wheel turns the faster, the faster it rolls
constexpr double kSlowTaxiMps = 3.0;
constexpr double kAileronPerMps = 0.1;
constexpr double kFastMps = 35.0;

} // namespace

double GroundSteering::step(const FlightSense& sense, const CourseLine& line, double stepS)
{
    const double lean = std::clamp(std::atan(line.besideM(sense.position) / kLeadM), -kMostLean, kMostLean);
    const double speed = std::max(sense.groundSpeedMps, kSlowTaxiMps), most = kMostSidewaysMps2 / speed;
    const double wanted = std::clamp(kTurnPerS * halfTurn(line.course - lean - sense.heading), -most, most);
    const double error = wanted - sense.yawRate;
    _held = std::clamp(_held - kIntegralGainMps / speed * error * stepS, -1.0, 1.0);
    return std::clamp(_held - kRateGainMps / speed * error, -1.0, 1.0);
}

double windFromRightMps(const FlightSense& sense, const CourseLine& line)
{
    const glm::dvec2 along = line.along();
    return sense.windMps.y * along.x - sense.windMps.x * along.y;
}

double aileronIntoWind(const FlightSense& sense, const CourseLine& line)
{
    const double share = std::clamp(1.0 - sense.groundSpeedMps / kFastMps, 0.2, 1.0);
    return std::clamp(kAileronPerMps * windFromRightMps(sense, line) * share, -0.8, 0.8);
}

} // namespace simulation
