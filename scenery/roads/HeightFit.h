// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace scenery
{

/// By how much the height of one node may lie above that of another. Units: metres.
struct HeightStep
{
    std::size_t from = 0, to = 0;
    double leastM = 0.0, mostM = 0.0; ///< of the height at `to` less that at `from`
};

/// Between which heights a node lies. Units: metres.
struct HeightBound
{
    std::size_t node = 0;
    double leastM = -std::numeric_limits<double>::infinity(), mostM = std::numeric_limits<double>::infinity();
};

/// Returns the heights that depart least from the wished ones, at the worst node, among those that keep every
/// step. Where nothing forces it to, no height departs from its wish.
/// Method: the greatest heights that no wish forbids from above and the least that none forbids from below,
/// by shortest paths over the steps; the mean of both. Steps that contradict each other are kept as far as
/// kMostPasses passes bring them.
/// Cost: 10 ns a step and pass; few passes where neighbours follow each other in `steps`.
/// Source: McShane, *Extension of range of functions*, 1934 (both extensions); Bellman, *On a routing
/// problem*, 1958.
std::vector<double> fitHeights(const std::vector<double>& wishesM, const std::vector<HeightStep>& steps);

/// Moves wishes as little as needed into bounds, and those around them as the steps ask, so that fitHeights()
/// of the result keeps the bounds, too. Where a least and a greatest height contradict each other, the least
/// is kept. Method and cost: as fitHeights().
std::vector<double> boundWishes(std::vector<double> wishesM, const std::vector<HeightStep>& steps,
                                const std::vector<HeightBound>& bounds);

} // namespace scenery
