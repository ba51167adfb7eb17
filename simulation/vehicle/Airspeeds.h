// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/state/EntityState.h"
#include "simulation/vehicle/Air.h"
#include "simulation/vehicle/StandardAtmosphere.h"

namespace simulation
{

/// Writes how fast an aircraft goes through the air: true and calibrated. Units: m/s.
inline void writeAirspeed(double trueMps, const AirSample& air, EntityState& entity)
{
    if (!entity.readings) entity.readings.emplace();
    entity.readings->trueAirspeedMps = trueMps;
    entity.readings->calibratedAirspeedMps =
        calibratedAirspeed(trueMps, {air.pressurePa, air.temperatureK, air.densityKgPerM3});
}

} // namespace simulation
