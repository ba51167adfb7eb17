// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/vec2.hpp>

#include <osg/Node>
#include <osg/ref_ptr>

#include <osgTerrainROAM/core/RoamFile.h>

#include "SceneTerrain.h"
#include "scenery/lights/StreetLamps.h"
#include "scenery/roads/things/RoadThings.h"
#include "scenery/structures/Structure.h"

namespace trainer
{

/// Walls, fences, power lines, railways, wind turbines and windsocks of a world, and what it tells of street
/// lamps.
struct MadeStructures
{
    std::vector<scenery::Structure> structures;
    osg::ref_ptr<osg::Node> node;       ///< of the structures; null: there are none
    simulation::ObstacleList obstacles; ///< of the structures, where they are wanted
    std::vector<glm::dvec2> windsocks;
    scenery::MappedLamps lamps;
    std::size_t unused = 0, beyondGround = 0;
    std::vector<std::string> notes; ///< of the sources
};

/// Makes what a .roam file's `structures` put on the ground. Errors: those of importShapes(); a source
/// without anything that can stand here.
/// Threads: any, as long as nobody changes the tile: nothing is written but what is returned.
foundation::Result<MadeStructures> makeStructures(const osgTerrainROAM::core::RoamFile& description,
                                                  const osgTerrainROAM::core::RoamTile& tile,
                                                  bool wantsObstacles);

/// Adds structures to a scene, and its runways with what stands at them: PAPI at both ends of paved ones of
/// kLeastPapiM or more, the lamps of their class, those of taxiways, their signs, and windsocks; and tells
/// what could not be used. Errors: tunnels of railways whose openings cannot be cut.
foundation::Outcome addStructures(const MadeStructures& made, const SceneAirfields& airfields,
                                  const scenery::roads::RoadThings& signs, SceneTerrain& scene);

/// Returns the signs beside the holding positions of airfields.
scenery::roads::RoadThings airfieldSigns(const SceneAirfields& airfields,
                                         const osgTerrainROAM::core::PlacedTile& tile);

inline constexpr double kLeastPapiM = 600.0;

} // namespace trainer
