// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "worldmaking/streets/HeightNodes.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetProfile.h"

namespace worldmaking
{

/// The nodes on both sides of an overpass: the curve between them is lower than a peak at one of them.
struct OverpassNodes
{
    std::array<std::size_t, 2> lower, upper;

    template<class Holds>
    bool all(const Holds& holds) const
    {
        for (const std::size_t below : lower)
            for (const std::size_t above : upper)
                if (!holds(below, above)) return false;
        return true;
    }
};

struct FittedHeights
{
    std::vector<double> heightsM;      ///< of each node
    std::vector<CrossingPlane> planes; ///< of each area
    std::size_t lostOverpasses = 0;    ///< without headroom: the map leaves no room for the rise
};

/// Finds the heights nearest to the wished ones that keep the grade of each street's class, hold the mouths
/// of roads in the planes of their areas, and leave headroom at overpasses (scenery::fitHeights()). A plane
/// leans as its arms do, by kMostLean at most. Where these contradict each other, planes lean less (short
/// roads between planes that lean apart; level planes always fit), then overpasses are given up (a bridge too
/// close to the crossing that it passes).
/// `wishesM`: of each node.
FittedHeights fitToLimits(const StreetGraph& graph, const HeightNodes& nodes,
                          const std::vector<double>& wishesM, std::vector<OverpassNodes> overpasses);

inline constexpr double kMostLean = 0.05; ///< metres per metre

} // namespace worldmaking
