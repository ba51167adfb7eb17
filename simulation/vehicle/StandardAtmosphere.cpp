// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/StandardAtmosphere.h"

#include <algorithm>
#include <cmath>

namespace simulation
{

namespace
{

constexpr double kGeopotentialRadiusM = 6356766.0;
constexpr double kLapseRate = 0.0065; ///< K/m in the troposphere
constexpr double kTropopauseM = 11000.0;
constexpr double kHeatRatio = 1.4;

/// The exponent of the pressure in the height of the standard troposphere.
constexpr double kHeightPower = kGasConstant * kLapseRate / foundation::kStandardGravityMps2;

double geopotentialOf(double heightM)
{
    return kGeopotentialRadiusM * heightM / (kGeopotentialRadiusM + heightM);
}

/// The height of a pressure in the standard troposphere, geopotential.
double standardHeightOf(double pressurePa)
{
    return kSeaTemperatureK / kLapseRate * (1.0 - std::pow(pressurePa / kSeaPressurePa, kHeightPower));
}

/// Pressure of compressed air at a stagnation point, above the static pressure. Units: Pa.
double impactPressure(double speedMps, double pressurePa, double temperatureK)
{
    const double mach2 = speedMps * speedMps / (kHeatRatio * kGasConstant * temperatureK);
    return pressurePa * (std::pow(1.0 + 0.2 * mach2, 3.5) - 1.0);
}

/// The speed that an impact pressure stands for.
double speedOf(double impactPa, double pressurePa, double temperatureK)
{
    const double mach2 = 5.0 * (std::pow(impactPa / pressurePa + 1.0, 2.0 / 7.0) - 1.0);
    return std::sqrt(mach2 * kHeatRatio * kGasConstant * temperatureK);
}

} // namespace

AirState standardAtmosphere(double heightM, const AtmosphereOffsets& offsets)
{
    const double clamped = std::clamp(heightM, -2000.0, 20000.0);
    const double geopotentialM = geopotentialOf(clamped);
    const double lowerM = std::min(geopotentialM, kTropopauseM);
    const double seaK = kSeaTemperatureK + offsets.temperatureK;
    AirState air;
    air.temperatureK = seaK - kLapseRate * lowerM;
    air.pressurePa =
        offsets.seaPressurePa *
        std::pow(air.temperatureK / seaK, foundation::kStandardGravityMps2 / (kGasConstant * kLapseRate)) *
        std::exp(-foundation::kStandardGravityMps2 * (geopotentialM - lowerM) /
                 (kGasConstant * air.temperatureK));
    air.densityKgPerM3 = air.pressurePa / (kGasConstant * air.temperatureK);
    return air;
}

double calibratedAirspeed(double trueMps, const AirState& air)
{
    return speedOf(impactPressure(trueMps, air.pressurePa, air.temperatureK), kSeaPressurePa,
                   kSeaTemperatureK);
}

double trueAirspeed(double calibratedMps, const AirState& air)
{
    return speedOf(impactPressure(calibratedMps, kSeaPressurePa, kSeaTemperatureK), air.pressurePa,
                   air.temperatureK);
}

double altimeterHeight(double pressurePa, double settingPa)
{
    return standardHeightOf(pressurePa) - standardHeightOf(settingPa);
}

double pressureByReport(double heightM, double reportedPa)
{
    const double standardM = std::min(standardHeightOf(reportedPa) + geopotentialOf(heightM), kTropopauseM);
    return kSeaPressurePa * std::pow(1.0 - kLapseRate * standardM / kSeaTemperatureK, 1.0 / kHeightPower);
}

} // namespace simulation
