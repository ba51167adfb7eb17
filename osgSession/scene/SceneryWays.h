// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

#include "scenery/placement/Surroundings.h"
#include "simulation/player/ScenarioPlayer.h"

namespace trainer
{

/// Plays a scenario once without drawing and returns the paths of its entities and the strips to keep free of
/// objects: along driving entities (their width and a margin, with room for a chase camera at the first and
/// last points) and below entities that fly lower than tree tops. `longestS`: limit of the play. Returns
/// nothing when the scenario cannot be played. Cost: its steps.
scenery::Ways waysOf(const simulation::Scenario& scenario, const simulation::PlayerOptions& options,
                     double longestS);

/// Keeps the roads of a network clear, verges included; bridges and tunnels, too.
void keepRoadsClear(const osgRoads::core::PlacedNetwork& roads, scenery::Ways& ways);

} // namespace trainer
