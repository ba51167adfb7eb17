// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// Finds how far beyond its mouths each chain's road lies over, or beside, the paving of the other arms of
/// the crossing there: where arms leave a crossing at a sharp angle, and where a chain was too short for its
/// mouth. It is kMostSharedM at most, and half of the road. 0 for railways.
/// Cost: some microseconds for each pair of arms. Source: ours; distances of samples in the plane.
std::vector<ChainCut> sharedPaving(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                                   const std::vector<ChainCut>& mouths);

inline constexpr double kMostSharedM = 40.0;

} // namespace worldmaking
