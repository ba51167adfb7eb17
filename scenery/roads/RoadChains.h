// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/network/RoadNetwork.h>

namespace scenery
{

/// Roads one behind the other, with nothing but links between them.
struct RoadChain
{
    struct Link
    {
        int road = -1;
        bool isReversed = false; ///< the chain runs towards smaller s
        double startM = 0.0;     ///< where the road begins, along the chain
    };

    std::vector<Link> links;
    double lengthM = 0.0;
    int startArea = -1, endArea = -1; ///< where it begins and ends; -1: in the open
};

/// Where roads meet in more than a line: a junction with its connecting roads, several junctions that are
/// close together, a place where more than two roads are linked, and one link of a ring without any of these.
struct MeetingArea
{
    struct End
    {
        int road = -1;
        bool isEnd = false; ///< else the road's start
    };

    std::vector<int> inside; ///< roads that lie in it wholly
    std::vector<End> arms;   ///< of roads that leave it
};

/// How the roads of a network hang together. Indices are those of RoadNetwork::roads; roads that cannot be
/// used are in no part.
struct RoadChains
{
    std::vector<RoadChain> chains;
    std::vector<MeetingArea> areas;
};

/// Between two areas a road shorter than this lies in them, which then are one. Units: metres.
inline constexpr double kShortRoadM = 25.0;

/// Parts a network into chains and the areas between them. Links to a place within a road (virtual
/// junctions), and to ends that lie elsewhere, count for nothing.
RoadChains chainsOf(const osgRoads::core::RoadNetwork& network);

} // namespace scenery
