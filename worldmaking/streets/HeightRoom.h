// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "scenery/roads/HeightFit.h"

namespace worldmaking
{

/// Tells by how much steps let one node rise above another.
/// Source: Johnson, *Efficient algorithms for shortest paths in sparse networks*, 1977: heights that keep all
/// steps make every length at least 0, so Dijkstra's method serves.
class HeightRoom
{
public:
    /// `heightsM`: of each node; they keep all steps within `errorM`.
    HeightRoom(std::vector<double> heightsM, const std::vector<scenery::HeightStep>& steps);

    /// Returns how far the node `upper` can lie above `lower`, `riseM` at most.
    /// Cost: the nodes that steps hold closer to `lower` than that, times their logarithm.
    double mostM(std::size_t lower, std::size_t upper, double riseM) const;

    /// Tells whether the node `upper` can lie `riseM` above `lower`.
    bool allows(std::size_t lower, std::size_t upper, double riseM) const
    {
        return mostM(lower, upper, riseM) >= riseM;
    }

private:
    struct Edge
    {
        std::size_t to;
        double slackM; ///< how much the node `to` may rise while the other stays
    };

    std::vector<double> _heightsM;
    std::vector<std::vector<Edge>> _edges;
};

} // namespace worldmaking
