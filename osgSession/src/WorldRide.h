// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include <foundation/Result.h>

#include "scene/SceneTerrain.h"
#include "simulation/scenario/Scenario.h"
#include "simulation/vehicle/DynamicVehicle.h"
#include "simulation/vehicle/Ground.h"

namespace osgSession
{

/// The scenario of a ride of one vehicle through a world that is open: a road vehicle begins `startM` along
/// the way of a drive, an aircraft on the runway in use, or in the air where there is none.
/// `world`: its file. `ground`: as wheels meet it. Errors: no roads, a way that is shorter; no ground to fly
/// over.
foundation::Result<simulation::Scenario>
rideInWorld(const trainer::SceneTerrain& scene, const simulation::Ground& ground,
            const std::filesystem::path& world, const simulation::DynamicVehicle& vehicle, double startM);

} // namespace osgSession
