// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/WheelTurns.h"

#include <cmath>

#include <foundation/Angle.h>

namespace simulation
{
namespace
{

constexpr double kRunOutS = 4.0; ///< in which a free wheel slows down to a third

double turnedBy(double turnDeg, double radps, double stepS)
{
    const double turned = std::fmod(turnDeg + foundation::degreesOf(radps * stepS), 360.0);
    return turned < 0.0 ? turned + 360.0 : turned;
}

} // namespace

void WheelTurns::step(const AircraftData& aircraft, std::span<const Contact> contacts, double speedMps,
                      double propellerRadps, double stepS)
{
    _propellerDeg = turnedBy(_propellerDeg, propellerRadps, stepS);
    for (std::size_t i = 0; i < _wheels.size(); ++i)
    {
        if (!aircraft.contacts[i].isWheel) continue;
        Wheel& wheel = _wheels[i];
        if (contacts[i].loadN > 0.0)
            wheel.radps = speedMps / aircraft.contacts[i].radiusM;
        else
            wheel.radps *= std::exp(-stepS / kRunOutS);
        wheel.turnDeg = turnedBy(wheel.turnDeg, wheel.radps, stepS);
    }
}

} // namespace simulation
