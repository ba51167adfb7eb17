// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// From a street or the formation of a railway to the surface of a footbridge above it, metres.
double footbridgeAboveM(const StreetTraits& lower);

/// From the surface of a footbridge to a street or the formation of a railway above it, metres.
double footbridgeBelowM(const StreetTraits& upper);

/// Finds where the bridge of a path passes over one street or railway and under another. Both must be as far
/// apart as the bridge and the room around it ask for, less what it may fall or rise between both.
/// `places`: of the map's nodes. Cost: near-linear (a grid).
std::vector<Overpass> footLevels(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                                 const std::vector<CentreLine>& lines, const LandMap& land,
                                 const MapPlane& plane);

inline constexpr double kWalkersClearM = 2.5; ///< above a path

} // namespace worldmaking
