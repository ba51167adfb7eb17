// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include <foundation/Result.h>

#include "simulation/control/VehicleController.h"
#include "simulation/control/flight/RunwayStrip.h"
#include "simulation/scenario/Entity.h"
#include "simulation/vehicle/EarthFrame.h"

namespace simulation
{

/// Opens a vehicle by its data file: a road vehicle, an aircraft, or one that JSBSim flies, as the file's
/// root element says.
/// `origin`: of the scene; without one road vehicles drive on flat ground, and aircraft fly where earthOf()
/// says. `seed`: of turbulence.
/// Errors: those of the file; a root of another name.
foundation::Result<std::unique_ptr<DynamicVehicle>>
openVehicle(const std::filesystem::path& file, const std::optional<Geodetic>& origin, std::uint64_t seed);

/// The data file of a vehicle like an entity, by its category.
std::filesystem::path vehicleFileFor(const ScenarioObject& object);

/// The Earth below a scene; without an origin at 46° N, 8° E.
std::shared_ptr<const EarthFrame> earthOf(const std::optional<Geodetic>& origin);

/// Opens recorded inputs for a vehicle. Errors: those of readInputs() and of RecordedInputs::create().
foundation::Result<std::unique_ptr<VehicleController>> openInputs(const std::filesystem::path& file,
                                                                  const DynamicVehicle& vehicle);

/// Returns a strip as high as the ground at its threshold; at 0 where no ground is known. Units: metres,
/// degrees from north, clockwise.
RunwayStrip runwayOn(const Ground& ground, const glm::dvec2& threshold, double courseDeg, double lengthM,
                     double widthM);

} // namespace simulation
