// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/Hydrometeors.h"

#include <cmath>
#include <numbers>

namespace simulation
{
namespace
{

constexpr double kContrastDepth = 2.9957322735539909; // -ln 0.05

} // namespace

Hydrometeors rainOf(double mmPerHour)
{
    if (!(mmPerHour > 0.0)) return {};
    constexpr double kPerM3Mm = 8000.0, kLeastSeenMm = 2.0, kSquareMm = 1e-6;
    const double slope = 4.1 * std::pow(mmPerHour, -0.21); // per mm of diameter
    const double sizeMm = kLeastSeenMm + 1.0 / slope;      // mean of an exponential beyond its start
    Hydrometeors rain;
    rain.perM3 = kPerM3Mm / slope * std::exp(-slope * kLeastSeenMm);
    rain.sizeM = 1e-3 * sizeMm;
    rain.fallMps = 9.65 - 10.3 * std::exp(-0.6 * sizeMm);
    rain.extinctionPerM =
        std::numbers::pi * kPerM3Mm / (slope * slope * slope) * kSquareMm; // of D² over all sizes
    return rain;
}

Hydrometeors snowOf(double mmPerHour)
{
    if (!(mmPerHour > 0.0)) return {};
    constexpr double kFlakeM = 0.005, kDensity = 50.0, kFallMps = 1.0, kVisibilityOfOneMm = 1220.0;
    constexpr double kFlakeKg = std::numbers::pi / 6.0 * kFlakeM * kFlakeM * kFlakeM * kDensity;
    const double kgPerM2S = mmPerHour / 3600.0;
    return {.isSnow = true,
            .perM3 = kgPerM2S / (kFlakeKg * kFallMps),
            .sizeM = kFlakeM,
            .fallMps = kFallMps,
            .extinctionPerM = kContrastDepth / kVisibilityOfOneMm * mmPerHour};
}

double visibilityM(double clearM, const Hydrometeors& falling)
{
    return kContrastDepth / (kContrastDepth / clearM + falling.extinctionPerM);
}

} // namespace simulation
