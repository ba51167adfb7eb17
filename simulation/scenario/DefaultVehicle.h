// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "simulation/scenario/Entity.h"

namespace simulation
{

/// Returns a vehicle of usual size and performance for a category of the standard (car, van, truck, bus,
/// motorbike, bicycle …); of an unknown one a car. Sources of sizes: directive 96/53/EC for lorries and
/// buses, otherwise common makes.
Vehicle defaultVehicle(const std::string& category);

/// Gives a vehicle the two axles of a usual one of its category, as long and as wide as its box.
void fitDefaultAxles(Vehicle& vehicle);

} // namespace simulation
