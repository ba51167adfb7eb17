// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "hud/Gauge.h"
#include "simulation/vehicle/DynamicVehicle.h"
#include "view/HudUnits.h"

namespace trainer
{

/// What the head-up display of a kind of vehicle shows.
struct HudLayout
{
    std::vector<GaugeKind> gauges;
};

/// The gauges for a vehicle: of an aircraft airspeed, altitude, heading, vertical speed, engine and flaps; of
/// a road vehicle speed, engine and gear; of any other its speed.
HudLayout hudLayoutOf(const simulation::DynamicVehicle& vehicle, HudUnits units = HudUnits::usual);

/// The values of hudLayoutOf()'s gauges now, in their order and units.
std::vector<double> hudValuesOf(const simulation::DynamicVehicle& vehicle, HudUnits units = HudUnits::usual);

} // namespace trainer
