// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <foundation/ContentMark.h>
#include <foundation/KeptFrom.h>
#include <foundation/Result.h>

#include <osgRoads/core/surface/PagedRoadMesh.h>
#include <osgTerrainROAM/core/RoamFile.h>
#include <osgTerrainROAM/core/features/GroundFeature.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

#include "scenery/roads/PlaceRoads.h"

namespace scenery
{

/// Places the roads that a .roam file names on its tile and cuts the ground to them, unless the file names
/// edits: then the tile is cut already (loadRoamTile()). `placed` of the result is null when the file names
/// none. Errors: those of placeRoads() and cutRoads().
foundation::Result<SceneRoads> layRoads(const osgTerrainROAM::core::RoamFile& description,
                                        const std::shared_ptr<osgTerrainROAM::core::RoamTile>& tile);

/// Returns ribbons to paint on the ground for roads that are too far away to be drawn as meshes: as wide as
/// the lanes that cars use, unmarked; nothing on bridges and in tunnels, nothing beyond the end of a road
/// that no other one follows. Frame: the scene's.
std::vector<osgTerrainROAM::core::GroundFeature> farRoads(const osgRoads::core::PlacedNetwork& roads);

/// A tile whose ground is cut to its earthworks and to the roads on it.
struct RoadTile
{
    std::shared_ptr<osgTerrainROAM::core::RoamTile> tile;
    SceneRoads roads; ///< `placed` null: none are named
};

/// Loads the tile that a .roam file describes, shapes it by its earthworks and lays its roads, which are read
/// by another thread meanwhile. `kept`: as RoamTile's. Errors: those of loadRoamTile() and layRoads().
foundation::Result<RoadTile> loadRoadTile(const osgTerrainROAM::core::RoamFile& description,
                                          const foundation::KeptResults* kept = nullptr);

/// Returns the mark of what roads on a tile follow from besides the tile: their file and how it is placed.
/// Absent: the file cannot be read.
std::optional<foundation::ContentMark> markOfRoads(const osgTerrainROAM::core::RoamFile& description);

/// Returns the drawn surface of the roads of a description, found among the kept results or made and kept.
/// What is found stays packed until it is drawn. `mark`: markOfRoads(). `kept`: what follows from the tile
/// (RoamTile::mark()).
std::shared_ptr<const osgRoads::core::PagedRoadMesh>
roadMeshOf(const SceneRoads& roads, const std::optional<foundation::ContentMark>& mark,
           const foundation::KeptFrom& kept);

} // namespace scenery
