// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "scenery/roads/HeightFit.h"
#include "worldmaking/streets/HeightNodes.h"
#include "worldmaking/streets/StreetGraph.h"
#include "worldmaking/streets/StreetProfile.h"

namespace worldmaking
{

/// The nodes on both sides of an overpass: the curve between them is lower than a peak at one of them.
struct OverpassNodes
{
    std::array<std::size_t, 2> lower, upper;
    double riseM = 0.0;     ///< wanted; after the fit, what was found
    std::size_t number = 0; ///< of the overpass

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
    std::vector<std::size_t> lost;     ///< overpasses without headroom: the map leaves no room for the rise
};

/// A street and a railway that cross at one level: their nodes next to the crossing.
struct LevelNodes
{
    std::size_t street = 0, track = 0;
};

/// What a fit has to keep besides the grades of streets.
struct FitLimits
{
    std::vector<OverpassNodes> overpasses;
    std::vector<LevelNodes> levels;
    std::vector<scenery::HeightBound> bounds; ///< over what has heights of its own, and below the ground
};

/// Finds the heights nearest to the wished ones that keep the grade of each street's class, hold the mouths
/// of roads in the planes of their areas, and leave headroom at overpasses (scenery::fitHeights()). A plane
/// leans as its arms do, by kMostLean at most. Where these contradict each other, planes lean less (short
/// roads between planes that lean apart; level planes always fit), then overpasses get what rise there is
/// room for (a bridge too close to the crossing that it passes), or are given up.
/// `wishesM`: of each node.
FittedHeights fitToLimits(const StreetGraph& graph, const HeightNodes& nodes,
                          const std::vector<double>& wishesM, const FitLimits& limits);

inline constexpr double kMostLean = 0.05; ///< metres per metre

} // namespace worldmaking
