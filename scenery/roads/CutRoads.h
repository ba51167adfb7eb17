// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <foundation/Result.h>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/edit/Earthworks.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "scenery/roads/RoadBand.h"

namespace scenery
{

/// Lays roads into the ground of a tile: beds (roadBand()), and a smooth surface between and beside them
/// (RoadEdges), in one step of the editor. Where the tile's grid is finer than its raster, samples are added
/// near the roads; otherwise the raster's own change. Beds of `water` (in the scene) stay as they are but for
/// the beds of the roads themselves: a street beside a river gets a wall, and does not fill the river. Null:
/// there is none.
/// Errors: those of changesBy() and TileEditor::apply(); roads beyond the tile.
foundation::Result<osgTerrainROAM::core::EditReport>
cutRoads(osgTerrainROAM::core::TileEditor& editor, const osgRoads::core::PlacedNetwork& roads,
         const RoadCutShape& shape = {}, const osgTerrainROAM::core::Earthworks* water = nullptr);

} // namespace scenery
