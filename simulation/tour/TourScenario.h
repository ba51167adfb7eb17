// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/PathCurve.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// Makes a scenario in which one entity follows vertices (parameter: seconds) in summer weather.
/// `description` goes into the header.
Scenario tourScenario(const TourTerrain& terrain, ScenarioObject ownship,
                      const std::vector<PathVertex>& vertices, const std::string& description);

/// Makes an environment with the sun to the side and slightly behind an entity that moves along `headingRad`,
/// and 60 km of sight, as on a clear day.
Environment tourEnvironment(const TourTerrain& terrain, double headingRad);

} // namespace simulation
