// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/StreetGraph.h"

namespace worldmaking
{

/// A place where one street passes over another without meeting it. Units: metres along the centre lines.
struct Overpass
{
    std::size_t upper = 0, lower = 0; ///< chains
    double upperM = 0.0, lowerM = 0.0;
};

/// Overpasses of a map, and crossings of lines for which the map does not say which one is above.
struct Overpasses
{
    std::vector<Overpass> found;
    std::size_t untold = 0;
};

/// Finds where pieces of streets cross in the plan without a point in common: a bridge is above the ground,
/// and that above a tunnel.
/// `places`: of the map's nodes. Cost: near-linear in the number of pieces (a grid).
Overpasses overpassesOf(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                        const std::vector<CentreLine>& lines);

} // namespace worldmaking
