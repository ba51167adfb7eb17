// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// How much of a chain belongs to the crossings at its ends. Units: metres along its centre line.
struct ChainCut
{
    double startM = 0.0, endM = 0.0;
};

/// Finds where each chain's road begins and ends: where its paving has come clear of that of the other arms,
/// with room for the bends of turning traffic; at small angles it is looked for along the lines, which bend.
/// At least a fifth of a chain, and kLeastRoadM of it, is left to the road.
/// `lines`: of the chains. Source: ours; the distance at which the borders of two strips meet, by plane
/// geometry.
std::vector<ChainCut> mouthsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines);

inline constexpr double kLeastRoadM = 1.0;

} // namespace worldmaking
