// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "simulation/vehicle/flight/Aerodynamics.h"
#include "simulation/vehicle/flight/FlightInputs.h"
#include "simulation/vehicle/flight/PistonEngine.h"
#include "simulation/vehicle/flight/Propeller.h"
#include "simulation/vehicle/flight/RigidBody.h"

namespace simulation
{

inline constexpr std::size_t kMostTanks = 4;

/// All that changes in an aircraft that flies.
struct FlightState
{
    BodyMotion motion;
    double engineRadps = 0.0;
    double manifoldPa = 101325.0;
    double flapDeg = 0.0;
    double stalled = 0.0;
    double alphaRate = 0.0;
    std::array<double, kMostTanks> fuelKg{};
};

/// What meets an aircraft at its place.
struct FlightSurroundings
{
    AirSample air;
    glm::dvec3 gust{0.0};      ///< the air's velocity besides the wind, body axes
    glm::dvec3 gustRates{0.0}; ///< the air's turning, body axes
    glm::dvec3 earthRate{0.0};
    double heightOverSpan = 10.0;
};

/// Forces without gravity and ground, and where they come from.
struct FlightLoads
{
    ForceMoment load; ///< about the centre of mass, body axes
    AirData air;
    PropellerOutput propeller;
    EngineOutput engine;
};

/// The surfaces at given inputs and flap angle.
SurfaceAngles surfaceAngles(const AircraftData& aircraft, const FlightInputs& inputs, double flapDeg);

/// Air, propeller and engine at one state. A function of its arguments alone: stepping and trimming use the
/// same.
FlightLoads flightLoads(const AircraftData& aircraft, const MassProperties& mass, const FlightState& state,
                        const FlightInputs& inputs, const FlightSurroundings& surroundings);

} // namespace simulation
