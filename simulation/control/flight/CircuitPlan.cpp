// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/CircuitPlan.h"

#include <cmath>
#include <numbers>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{
namespace
{

constexpr double kOffsetM = 1000.0;   ///< of the downwind leg from the centre line
constexpr double kPatternM = 250.0;   ///< above the runway
constexpr double kLeastTurnM = 120.0; ///< above the runway, below which nothing turns
constexpr double kBaseM = 2000.0;     ///< of the base leg before the threshold
constexpr double kPatternMps = 43.0, kBaseMps = 36.0;
constexpr double kTurnBankRad = 0.30; ///< for which turns are begun ahead

constexpr double kRollInS = 2.0;

/// How far ahead a turn by a right angle begins.
double leadM(const FlightSense& sense)
{
    return sense.groundSpeedMps * sense.groundSpeedMps / (kStandardGravity * std::tan(kTurnBankRad)) +
           kRollInS * sense.groundSpeedMps;
}

} // namespace

void CircuitPlan::advance(const FlightSense& sense)
{
    const CourseLine centre = _runway.centreLine();
    const double along = centre.alongM(sense.position), left = -centre.besideM(sense.position);
    const double height = sense.position.z - _runway.threshold.z, lead = leadM(sense);
    if (_leg == kUpwind && along > _runway.lengthM && height > kLeastTurnM)
    {
        _turnM = along + lead;
        _leg = kCrosswind;
    }
    else if (_leg == kCrosswind && left > kOffsetM - lead)
        _leg = kDownwind;
    else if (_leg == kDownwind && along < -kBaseM + lead)
        _leg = kBase;
    else if (_leg == kBase && left < lead)
        ++_leg;
}

CircuitPlan::Leg CircuitPlan::leg() const
{
    constexpr double kRightAngle = std::numbers::pi / 2.0;
    const CourseLine centre = _runway.centreLine();
    const glm::dvec2 along = centre.along(), left(-along.y, along.x);
    const double patternM = _runway.threshold.z + kPatternM;
    switch (_leg)
    {
    case kUpwind:
        return {centre, patternM, kPatternMps, 0.0, "upwind"};
    case kCrosswind:
        return {{centre.point + _turnM * along, centre.course - kRightAngle},
                patternM,
                kPatternMps,
                0.0,
                "crosswind"};
    case kDownwind:
        return {{centre.point + kOffsetM * left, centre.course + 2.0 * kRightAngle},
                patternM,
                kPatternMps,
                0.0,
                "downwind"};
    default:
        return {{centre.point - kBaseM * along, centre.course + kRightAngle},
                _runway.threshold.z + 0.7 * kPatternM,
                kBaseMps,
                1.0 / 3.0,
                "base"};
    }
}

} // namespace simulation
