// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "SceneTerrain.h"
#include "request/PlayRequest.h"
#include "simulation/road/RoadScene.h"

namespace trainer
{

/// The roads of a scene as entities drive on them, in its frame. Cost: milliseconds a kilometre. Null: the
/// scene has none.
std::shared_ptr<const simulation::RoadScene> roadSceneOf(const SceneTerrain& scene);

/// Gives a ride in a scene, which no scenario is played in, what its roads have: where its traffic drives,
/// where it has some, and what their lights do.
void addRoads(PlayRequest& ride, const SceneTerrain& scene);

} // namespace trainer
