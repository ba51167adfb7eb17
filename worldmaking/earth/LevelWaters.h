// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <osgRoads/core/network/RoadNetwork.h>
#include <osgTerrainROAM/core/edit/Earthworks.h>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"

namespace worldmaking
{

/// Cuts the open waters of a map down to where the ground is at their level: rivers to the beds of their
/// lines, and all waters off the ground that carries roads, for which elevation data often leave no room
/// beside a river. An area may fall into several; one of which nothing is left goes. `works`: of the waters,
/// `network`: of the roads, both in the plane. Returns the number of areas that went.
/// Cost: some milliseconds an area.
std::size_t cutToLevel(LandMap& map, const MapPlane& plane,
                       std::span<const osgTerrainROAM::core::Earthwork> works,
                       const osgRoads::core::RoadNetwork& network);

} // namespace worldmaking
