// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/player/PathCurve.h"
#include "simulation/tour/TourTerrain.h"

namespace simulation
{

/// A scenario in which one entity runs along vertices (parameter: seconds), under a summer's sky.
/// `description` goes into the header.
Scenario tourScenario(const TourTerrain& terrain, ScenarioObject ownship,
                      const std::vector<PathVertex>& vertices, const std::string& description);

/// Sun to the side and somewhat behind who moves along `headingRad`; air clear enough for the extent.
Environment tourEnvironment(const TourTerrain& terrain, double headingRad);

} // namespace simulation
