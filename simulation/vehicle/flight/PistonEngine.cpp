// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/flight/PistonEngine.h"

#include <algorithm>
#include <numbers>

#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

namespace
{

constexpr double kStoichiometricAirPerFuel = 14.7; ///< aviation gasoline, by mass

double turnsPerS(double speedRadps)
{
    return std::max(speedRadps, 0.0) / (2.0 * std::numbers::pi);
}

} // namespace

double steadyManifoldPa(const EngineData& engine, double throttle, double speedRadps, double ambientPa)
{
    const double opening = engine.idleOpening + (1.0 - engine.idleOpening) * std::clamp(throttle, 0.0, 1.0);
    const double loss = engine.intakeLoss + engine.throttleLoss * (1.0 - opening) * (1.0 - opening);
    return ambientPa / (1.0 + turnsPerS(speedRadps) * loss);
}

EngineOutput engineOutput(const EngineData& engine, const EngineControls& controls, double speedRadps,
                          double manifoldPa, const AirSample& air)
{
    const double suction = std::max(air.pressurePa - manifoldPa, 0.0);
    const double friction = engine.frictionNm * std::clamp(speedRadps / 5.0, 0.0, 1.0) +
                            engine.frictionNms * std::max(speedRadps, 0.0) + engine.pumpingNmPerPa * suction;
    EngineOutput output;
    output.torqueNm = controls.starter * engine.starterNm - friction;
    if (!controls.hasFuel || controls.ignition < 0.5 || speedRadps < engine.stopRadps) return output;
    const double charge =
        std::max(manifoldPa - engine.residualShare * air.pressurePa, 0.0) / (kGasConstant * air.temperatureK);
    const double airKgPerS =
        engine.volumetricEfficiency * charge * engine.displacementM3 * 0.5 * turnsPerS(speedRadps);
    const double richness = engine.fullRichness * std::clamp(controls.mixture, 0.0, 1.0) * kSeaPressurePa /
                            std::max(air.pressurePa, 1.0);
    output.fuelKgPerS = airKgPerS * richness / kStoichiometricAirPerFuel;
    output.torqueNm +=
        output.fuelKgPerS * engine.heatingValueJPerKg * engine.efficiency.at(richness) / speedRadps;
    return output;
}

} // namespace simulation
