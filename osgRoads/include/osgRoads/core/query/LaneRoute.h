// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <foundation/Result.h>

#include <osgRoads/core/query/LaneGraph.h>

namespace osgRoads::core
{

/// A stretch of one lane on a route, from sFrom to sTo (descending against the road). Of a lane that is left
/// sideways, all but an empty stretch belongs to the lane changed to.
struct RouteLeg
{
    LaneKey lane;
    double sFrom = 0.0, sTo = 0.0;
    bool isLaneChange = false; ///< whether it is entered from the side
};

struct LaneRoute
{
    std::vector<RouteLeg> legs;
    double lengthM = 0.0;

    /// Returns the middle of the lane so far along the route; its ends beyond it.
    /// Errors: a route without legs is a broken contract.
    RoadPosition at(const RoadNetwork& network, double distanceM) const;
};

/// Finds the shortest route between two road positions over lanes that cars use. A lane change counts as
/// kLaneChangeM. Errors (`place` is "route"): a position is on no such lane, or no route leads there.
/// Source: Dijkstra, *A note on two problems in connexion with graphs*, 1959.
foundation::Result<LaneRoute> findRoute(const RoadNetwork& network, const LaneGraph& graph,
                                        const RoadPosition& from, const RoadPosition& to);

inline constexpr double kLaneChangeM = 20.0;

} // namespace osgRoads::core
