// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

#include <foundation/Result.h>

#include <osgRoads/core/place/PlacedNetwork.h>

#include "SceneTerrain.h"

namespace trainer
{

/// Returns the ground with the roads on it (scenery::heightOnRoads()). Frame: the scene's. Ownership: shares
/// the network.
simulation::GroundProvider groundWithRoads(simulation::GroundProvider ground,
                                           std::shared_ptr<const osgRoads::core::PlacedNetwork> roads);

/// Makes the terrain that a .roam file describes with the roads that it names, if any: the ground is cut to
/// them, they are painted on it for far eyes, and drawn. Problems of the network are told through
/// osg::notify(NOTICE). The strip of the request is laid after the roads. Errors: as makeTerrain(),
/// scenery::layRoads() and layStrip().
foundation::Result<SceneTerrain> makeTerrainWithRoads(const osgTerrainROAM::core::RoamFile& description,
                                                      const TerrainRequest& request);

/// Opens an OpenDRIVE network as a scene of its own: roads on made ground (scenery::makeRoadGround(), whose
/// errors it returns).
foundation::Result<SceneTerrain> openNetwork(const std::filesystem::path& file,
                                             const TerrainRequest& request);

/// Gives the roads of a scene the error target of its terrain; their own part of it is
/// RoadViewSettings::tolerancePx.
void setRoadTolerance(osg::Node& scene, double errorTolerancePx);

} // namespace trainer
