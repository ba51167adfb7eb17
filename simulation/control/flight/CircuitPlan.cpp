// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/flight/CircuitPlan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{
namespace
{

constexpr double kOffsetM = 1000.0;                              ///< of the downwind leg from the centre line
constexpr double kMostPatternM = 450.0, kClearOfGroundM = 100.0; ///< above the runway, above the ground below
constexpr double kLeastTurnM = 120.0; ///< above the runway, below which nothing turns
constexpr double kBaseM = 2000.0;     ///< of the base leg before the threshold
constexpr double kPatternMps = 43.0, kBaseMps = 36.0;
constexpr double kTurnBankRad = 0.30; ///< for which turns are begun ahead

constexpr double kRollInS = 2.0;

/// How far ahead a turn by a right angle begins.
double leadM(const FlightSense& sense)
{
    return sense.groundSpeedMps * sense.groundSpeedMps /
               (foundation::kStandardGravityMps2 * std::tan(kTurnBankRad)) +
           kRollInS * sense.groundSpeedMps;
}

/// How high above the runway a circuit on one side has to be to clear the ground below it.
double needOn(const RunwayStrip& runway, const Ground& ground, double side)
{
    constexpr double kNextM = 150.0, kBeyondM = 1500.0, kAroundM = 450.0;
    const glm::dvec2 along = runway.centreLine().along(), beside = side * glm::dvec2(-along.y, along.x);
    double highestM = runway.threshold.z;
    for (double at = -kBaseM - kAroundM; at <= runway.lengthM + kBeyondM; at += kNextM)
        for (double aside = 0.0; aside <= kOffsetM + kAroundM; aside += kNextM)
        {
            const glm::dvec3 place(glm::dvec2(runway.threshold) + at * along + aside * beside, 1e4);
            GroundPoint below;
            ground.heightsBelow({&place, 1}, {&below, 1});
            if (below.isKnown) highestM = std::max(highestM, below.heightM);
        }
    return highestM + kClearOfGroundM - runway.threshold.z;
}

} // namespace

CircuitPlan::CircuitPlan(const RunwayStrip& runway, const Ground& ground) : _runway(runway)
{
    const double leftM = needOn(runway, ground, 1.0);
    if (leftM <= _patternM) return;
    const double rightM = needOn(runway, ground, -1.0);
    if (rightM < leftM) _side = -1.0;
    _patternM = std::clamp(std::min(leftM, rightM), _patternM, kMostPatternM);
}

void CircuitPlan::advance(const FlightSense& sense)
{
    const CourseLine centre = _runway.centreLine();
    const double along = centre.alongM(sense.position), left = -_side * centre.besideM(sense.position);
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
    const glm::dvec2 along = centre.along(), left = _side * glm::dvec2(-along.y, along.x);
    const double patternM = _runway.threshold.z + _patternM;
    switch (_leg)
    {
    case kUpwind:
        return {centre, patternM, kPatternMps, 0.0, "upwind"};
    case kCrosswind:
        return {{centre.point + _turnM * along, centre.course - _side * kRightAngle},
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
        return {{centre.point - kBaseM * along, centre.course + _side * kRightAngle},
                _runway.threshold.z + 0.7 * _patternM,
                kBaseMps,
                1.0 / 3.0,
                "base"};
    }
}

} // namespace simulation
