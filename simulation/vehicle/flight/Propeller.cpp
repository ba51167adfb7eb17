// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/Propeller.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace simulation
{

PropellerOutput propellerOutput(const PropellerData& propeller, double speedRadps, double forwardMps,
                                double densityKgPerM3)
{
    const double turnsPerS = std::max(speedRadps, 0.0) / (2.0 * std::numbers::pi);
    const double diameter = propeller.diameterM;
    const double advance = forwardMps / std::max(turnsPerS * diameter, 1e-3);
    const double scale = densityKgPerM3 * turnsPerS * turnsPerS * std::pow(diameter, 4);
    PropellerOutput output;
    output.thrustN = propeller.thrust.at(advance) * scale;
    output.torqueNm = propeller.power.at(advance) * scale * diameter / (2.0 * std::numbers::pi);
    const double discM2 = 0.25 * std::numbers::pi * diameter * diameter;
    const double square =
        forwardMps * std::abs(forwardMps) + 2.0 * output.thrustN / (densityKgPerM3 * discM2);
    output.inducedVelocityMps = square > 0.0 ? 0.5 * (std::sqrt(square) - forwardMps) : -0.5 * forwardMps;
    return output;
}

} // namespace simulation
