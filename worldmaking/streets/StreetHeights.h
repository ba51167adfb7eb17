// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/streets/HeightNodes.h"
#include "worldmaking/streets/Overpass.h"
#include "worldmaking/streets/SmoothGround.h"
#include "worldmaking/streets/StreetProfile.h"

namespace worldmaking
{

struct StreetHeights
{
    std::vector<StreetProfile> profiles; ///< of each chain
    std::vector<CrossingPlane> planes;   ///< of each crossing
    std::size_t lostOverpasses = 0;      ///< without headroom: the map leaves no room for the rise
};

/// Finds the heights of all streets over a ground: close to it where they lie on it, through hills in tunnels
/// and over valleys on bridges, within the grades of their classes, with headroom where one passes over
/// another.
/// Method: smoothGround() gives the wished heights, fitToLimits() those nearest to them that keep the limits,
/// profileOf() the curves.
StreetHeights heightsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts, const std::vector<Overpass>& overpasses,
                        const GroundHeight& ground);

} // namespace worldmaking
