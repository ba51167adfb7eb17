// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "simulation/state/EnvironmentState.h"
#include "simulation/vehicle/WeatherAir.h"

namespace simulation
{

/// Returns the air of a scenario's environment: its wind, and the temperature and pressure that it gives for
/// the scene's origin, at `originHeightM` above the ellipsoid, carried down to the sea by the standard
/// atmosphere. A pressure that a report has reduced to the sea is first that of the origin again
/// (pressureByReport()): an altimeter that is set to it shows the origin's height on a warm day, too. What it
/// does not give is standard.
WeatherSettings weatherOf(const EnvironmentState& environment, double originHeightM = 0.0);

} // namespace simulation
