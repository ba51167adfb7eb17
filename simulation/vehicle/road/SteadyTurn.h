// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "simulation/vehicle/road/RoadVehicleData.h"

namespace simulation
{

/// Cornering stiffness of each axle at the loads at rest. Units: N/rad.
std::array<double, 2> axleStiffness(const RoadVehicleData& vehicle);

/// How much more a vehicle has to be steered in a steady turn at speed than at a walk: angle over curvature
/// and speed squared. Positive: it understeers. Units: rad s²/m. Source: Riekert, Schunck, *Zur Fahrmechanik
/// des gummibereiften Kraftfahrzeugs*, 1940 (the linear single-track model).
double understeerOf(const RoadVehicleData& vehicle);

} // namespace simulation
