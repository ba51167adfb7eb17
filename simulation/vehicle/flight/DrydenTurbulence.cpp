// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/DrydenTurbulence.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <foundation/Units.h>

namespace simulation
{

namespace
{

constexpr double kHighLengthM = 1750.0 * foundation::kMetresPerFoot;
constexpr double kLowM = 1000.0 * foundation::kMetresPerFoot, kHighM = 2000.0 * foundation::kMetresPerFoot;
constexpr double kSlowestMps = 5.0; ///< slower, the air drifts past at this speed

/// Strength near the ground, at a height of 3 m to 1000 ft.
DrydenTurbulence::Strength lowStrength(double heightM, double windMps)
{
    const double heightFt = std::clamp(heightM / foundation::kMetresPerFoot, 10.0, 1000.0);
    const double shape = 0.177 + 0.000823 * heightFt;
    const double level = heightFt * foundation::kMetresPerFoot / std::pow(shape, 1.2);
    const double down = 0.1 * windMps;
    const double flat = down / std::pow(shape, 0.4);
    return {{level, level, heightFt * foundation::kMetresPerFoot}, {flat, flat, down}};
}

} // namespace

DrydenTurbulence::Strength DrydenTurbulence::strengthOf(const TurbulenceConditions& conditions)
{
    const Strength low = lowStrength(conditions.heightM, conditions.windAtSixMetresMps);
    const double share = std::clamp((conditions.heightM - kLowM) / (kHighM - kLowM), 0.0, 1.0);
    return {glm::mix(low.lengthM, glm::dvec3(kHighLengthM), share),
            glm::mix(low.deviationMps, glm::dvec3(conditions.gustDeviationMps), share)};
}

double DrydenTurbulence::noise()
{
    // Box-Muller; the distributions of the standard library differ between its makers.
    const auto uniform = [this] { return (static_cast<double>(_random() >> 11U) + 0.5) * 0x1p-53; };
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

/// The first state is a lag of white noise with deviation 1/√2, the second a lag of the first;
/// √3·first + (1 - √3)·second has the spectrum (1 + 3(Lω/V)²)/(1 + (Lω/V)²)² and deviation 1.
double DrydenTurbulence::Transverse::step(double decay, double stepShare, double noise)
{
    const double before = first;
    first = decay * first + std::sqrt(0.5 * (1.0 - decay * decay)) * noise;
    second = decay * second + stepShare * decay * 0.5 * (before + first / decay);
    return std::numbers::sqrt3 * first + (1.0 - std::numbers::sqrt3) * second;
}

void DrydenTurbulence::step(const TurbulenceConditions& conditions, double stepS)
{
    const Strength strength = strengthOf(conditions);
    const double speed = std::max(conditions.speedMps, kSlowestMps);
    const double span = conditions.wingSpanM;
    const auto stepShare = [&](double lengthM) { return stepS * speed / lengthM; };
    const double along = std::exp(-stepShare(strength.lengthM.x));
    _along = along * _along + std::sqrt(1.0 - along * along) * noise();
    const glm::dvec3 share(0.0, stepShare(strength.lengthM.y), stepShare(strength.lengthM.z));
    const double across = _across.step(std::exp(-share.y), share.y, noise());
    const double down = _down.step(std::exp(-share.z), share.z, noise());
    _velocity = strength.deviationMps * glm::dvec3(_along, across, down);

    const double pi = std::numbers::pi;
    const double rollDecay = std::exp(-stepS * pi * speed / (4.0 * span));
    const double rollDeviation = strength.deviationMps.z * std::sqrt(0.1 * pi * pi * std::cbrt(0.25 * pi)) /
                                 std::cbrt(strength.lengthM.z * span * span);
    _roll = rollDecay * _roll + std::sqrt(1.0 - rollDecay * rollDecay) * noise();
    const double pitchTime = 4.0 * span / (pi * speed), yawTime = 3.0 * span / (pi * speed);
    _pitchLag += (1.0 - std::exp(-stepS / pitchTime)) * (_velocity.z - _pitchLag);
    _yawLag += (1.0 - std::exp(-stepS / yawTime)) * (_velocity.y - _yawLag);
    _rates = {rollDeviation * _roll, -(_velocity.z - _pitchLag) / (pitchTime * speed),
              (_velocity.y - _yawLag) / (yawTime * speed)};
}

} // namespace simulation
