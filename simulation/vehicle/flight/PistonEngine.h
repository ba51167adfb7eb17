// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/vehicle/Air.h"
#include "simulation/vehicle/flight/AircraftData.h"

namespace simulation
{

/// The hands on an engine, each 0…1.
struct EngineControls
{
    double throttle = 0.0;
    double mixture = 1.0;
    double ignition = 1.0;
    double starter = 0.0;
    bool hasFuel = true;
};

struct EngineOutput
{
    double torqueNm = 0.0; ///< at the shaft
    double fuelKgPerS = 0.0;
};

/// The pressure towards which the manifold tends: air loses pressure in the intake and at the throttle.
/// Units: Pa, rad/s.
double steadyManifoldPa(const EngineData& engine, double throttle, double speedRadps, double ambientPa);

/// Shaft torque and fuel of a piston engine without supercharger at a manifold pressure.
/// Indicated work from fuel and its efficiency over richness, less friction and pumping. The carburettor
/// enriches with height.
/// Source: Heywood, *Internal Combustion Engine Fundamentals*, 1988, sections 2.9, 6.2, 13.5; Taylor, *The
/// Internal Combustion Engine in Theory and Practice*, 2nd edition, 1985, volume 1, chapter 6 (volumetric
/// efficiency and residual gas).
EngineOutput engineOutput(const EngineData& engine, const EngineControls& controls, double speedRadps,
                          double manifoldPa, const AirSample& air);

} // namespace simulation
