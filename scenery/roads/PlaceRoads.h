// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <foundation/Result.h>
#include <glm/glm.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/read/Problem.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace scenery
{

/// Which heights roads on a terrain have.
enum class RoadHeights
{
    file,   ///< the file's, in the datum of the terrain's samples
    ground, ///< those of profiles on the ground (GroundProfiles.h) plus the file's
};

/// Where a network without a usable georeference lies.
struct RoadOrigin
{
    double latitudeDeg = 0.0, longitudeDeg = 0.0; ///< of the file's (0, 0)
    double headingDeg = 0.0;                      ///< of the file's y axis, clockwise from north
};

/// The roads that a terrain is to carry.
struct RoadsRequest
{
    std::filesystem::path file;
    std::optional<RoadOrigin> origin; ///< absent: by the file's geoReference
    RoadHeights heights = RoadHeights::file;
};

/// A network in the scene's frame.
struct SceneRoads
{
    std::shared_ptr<const osgRoads::core::PlacedNetwork> placed;
    std::vector<std::string> notes; ///< what is wrong with the file, and what is drawn otherwise, a line each
    std::string file;
};

/// The part of the plan that the usable roads of a network take up, lanes included. Frame: inertial. Units:
/// metres.
struct PlanExtent
{
    glm::dvec2 low{0.0}, high{0.0};
};
PlanExtent extentOf(const osgRoads::core::RoadNetwork& network);

/// A network as its file has it.
struct RoadsFile
{
    std::shared_ptr<const osgRoads::core::RoadNetwork> network;
    std::vector<std::string> notes; ///< as SceneRoads has them
};

/// Reads a network for a scene. Errors: those of readNetwork().
foundation::Result<RoadsFile> readRoads(const std::filesystem::path& file);

/// Places a network on a tile. On a planar tile the file's x and y are the tile's.
/// Errors: on a curved tile, neither a geoReference nor an origin; a place that PROJ cannot compute; roads
/// that lie beyond the tile's data.
foundation::Result<SceneRoads> placeRoads(const RoadsRequest& request, RoadsFile roads,
                                          const osgTerrainROAM::core::PlacedTile& tile);

/// The same for the file of the request. Errors: those of readRoads(), too.
foundation::Result<SceneRoads> placeRoads(const RoadsRequest& request,
                                          const osgTerrainROAM::core::PlacedTile& tile);

} // namespace scenery
