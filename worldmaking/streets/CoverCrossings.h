// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetHeights.h"
#include "worldmaking/streets/Tracks.h"

namespace worldmaking
{

/// Makes bridges and tunnels where ways cross and the map has none, or one that is too short to keep its
/// abutments off what lies below: bridges over railways, paths and rivers, tunnels under runways. Returns how
/// many are new. `network`: road i is chain i.
std::size_t coverCrossings(osgRoads::core::RoadNetwork& network, const StreetGraph& graph,
                           const std::vector<ChainCut>& cuts, const Crossings& crossings,
                           const StreetHeights& heights);

/// Returns the stretches of railways that pass over something, as long as its abutments need.
std::vector<TrackSpan> trackSpans(const StreetGraph& graph, const std::vector<ChainCut>& cuts,
                                  const Crossings& crossings, const StreetHeights& heights);

} // namespace worldmaking
