// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/models/Catalogue.h"
#include "scenery/placement/Measures.h"
#include "scenery/placement/PlaceScenery.h"
#include "simulation/contact/ObstacleMap.h"

namespace scenery
{

/// Adds what generated models of a scenery put in the way of vehicles: trunks by the kind of tree, bushes,
/// houses and vehicles by their base. Models of files are boxes of their base, as high as they are wide.
/// `measures`: of its objects, in the order of objectsOf().
void addObstacles(const SceneryDescription& description, const PlacedScenery& placed,
                  const std::vector<Measures>& measures, simulation::ObstacleList& obstacles);

} // namespace scenery
