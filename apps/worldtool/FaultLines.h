// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "worldmaking/check/WorldCheck.h"

namespace worldtool
{

/// Returns a line for each fault of roads, waters and crossings: the place, what is wrong, the remedy. After
/// kMostFaultLines of a kind the number of all.
std::vector<std::string> faultLines(const worldmaking::WorldFaults& faults,
                                    const osgRoads::core::PlacedNetwork* roads,
                                    const osgTerrainROAM::core::PlacedTile& tile);

inline constexpr std::size_t kMostFaultLines = 20;

} // namespace worldtool
