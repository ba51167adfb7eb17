// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <foundation/Heights.h>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Crossings.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetHeights.h"

namespace worldmaking
{

/// What is known of the ways of a graph, and of railways behind them.
struct KnownWays
{
    const std::vector<CentreLine>& lines;
    const std::vector<ChainCut>& cuts;
    const Crossings& crossings;
    const StreetHeights& heights;
};

/// Takes tunnels off the streets of a graph: those up to kShortTunnelM whose roof would stand above the
/// ground in their middle, since there is neither a hill nor room for ramps down, and that nothing passes
/// over. Mappers draw passages below houses so. Returns how many.
std::size_t openBareTunnels(StreetGraph& graph, const KnownWays& ways,
                            const foundation::HeightInPlan& ground);

inline constexpr double kShortTunnelM = 60.0;

} // namespace worldmaking
