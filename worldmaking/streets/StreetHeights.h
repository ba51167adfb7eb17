// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <foundation/Heights.h>

#include "worldmaking/streets/Crossings.h"
#include "worldmaking/streets/HeightNodes.h"
#include "worldmaking/streets/SmoothGround.h"
#include "worldmaking/streets/StreetProfile.h"

namespace worldmaking
{

/// A level crossing with the height of the street there.
struct LevelHeight
{
    std::size_t track = 0; ///< chain
    double trackM = 0.0;   ///< along it
    double streetM = 0.0;  ///< height
};

/// A tunnel whose roof lies above the ground: the map leaves no room for ramps.
struct BareTunnel
{
    std::size_t chain = 0;
    double alongM = 0.0, byM = 0.0; ///< where it is worst; of its roof above the ground
};

struct StreetHeights
{
    std::vector<StreetProfile> profiles; ///< of each chain
    std::vector<CrossingPlane> planes;   ///< of each crossing
    std::vector<std::size_t> lost;       ///< overpasses without headroom: the map leaves no room for the rise
    std::vector<std::size_t> lostCrossed; ///< crossed places likewise
    std::vector<BareTunnel> bareTunnels;
    std::vector<LevelHeight> levels;
};

/// Finds the heights of all streets and railways over a ground: close to it where they lie on it, through
/// hills in tunnels, below level ground where a tunnel has no hill, and over valleys on bridges, within the
/// grades of their classes, with headroom where one passes over another, and over and under what has heights
/// of its own.
/// Method: smoothGround() gives the wished heights, fitToLimits() those nearest to them that keep the limits,
/// profileOf() the curves.
StreetHeights heightsOf(const StreetGraph& graph, const std::vector<CentreLine>& lines,
                        const std::vector<ChainCut>& cuts, const Crossings& crossings,
                        const foundation::HeightInPlan& ground);

} // namespace worldmaking
