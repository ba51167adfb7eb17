// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "scenery/models/cockpit/Readings.h"
#include "scenery/models/entities/EntityModel.h"
#include "simulation/state/EntityState.h"
#include "simulation/vehicle/DynamicVehicle.h"

namespace trainer
{

/// What the instruments of a vehicle are told about.
struct CockpitState
{
    const simulation::EntityState& entity;
    scenery::models::LitLamps lamps{};
    const simulation::DynamicVehicle* vehicle = nullptr; ///< null: it moves without physics
    bool flies = false;                                  ///< it is an aircraft
    double seaHeightM = 0.0;                             ///< of the scene's height 0 above the sea
    double altimeterHpa = 1013.25;                       ///< to which the altimeter is set
};

/// What the instruments show. From the vehicle's physics where there is one. One that only moves has what
/// follows from its motion: speeds, height, attitude, a coordinated turn, gears as a car has them; its engine
/// turns as usual there, and its tanks are three quarters full, as are those of all road vehicles. The ball
/// tells of the forces of the air alone. Pure.
scenery::models::Readings cockpitReadings(const CockpitState& state);

} // namespace trainer
