// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Heights.h>
#include <foundation/Result.h>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "SceneTerrain.h"
#include "scenery/buildings/BuildingFacets.h"

namespace trainer
{

/// What stands on a ground by a map.
struct MapScenery
{
    std::vector<StandingPart> standing;
    std::vector<scenery::WindowPane> panes;  ///< of all windows
    std::vector<glm::dvec2> houses;          ///< middles of those where people live or work
    std::vector<scenery::LightPoint> lights; ///< beacons and lamps of obstacles
    simulation::ObstacleList obstacles;      ///< where they are wanted
    std::vector<std::string> notes;          ///< what could not be used, and how much could; a line each
};

/// Makes what a .roam file's `buildings` and `objects` put on the ground, houses with their doors to the
/// roads (null: none).
/// Errors: those of importShapes(); a source without anything that can stand here.
/// Threads: any, as long as nobody changes the tile: nothing is written but what is returned.
foundation::Result<MapScenery> makeMapScenery(const osgTerrainROAM::core::RoamFile& description,
                                              const osgTerrainROAM::core::RoamTile& tile,
                                              const foundation::HeightInPlan& ground,
                                              const osgRoads::core::PlacedNetwork* roads,
                                              bool wantsObstacles);

} // namespace trainer
