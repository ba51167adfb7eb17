// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
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
    double sine = 1.0;                               ///< of the angle between both
    double riseM = 0.0;                              ///< wanted between their heights
    double clearM = 0.0;                             ///< of that, what stays free
    bool isLowerTube = false;                        ///< the ground over a tunnel carries the upper one
    bool isUpperLifted = false, isLowerSunk = false; ///< who leaves the ground first, as the map has it
};

/// Overpasses of a map, and crossings of lines for which the map does not say which one is above.
struct Overpasses
{
    std::vector<Overpass> found;
    std::vector<Overpass> leftOpen; ///< `upper` and `lower` say nothing
};

/// What must lie between the heights of two ways. Units: metres.
struct Separation
{
    double riseM = 0.0, clearM = 0.0;
};

/// Returns the separation of a way that passes over another: 4.5 m clear above lanes, rails, and the wire of
/// rails, the deck, and what rounding takes. A tunnel has a roof besides.
Separation separationOf(const StreetTraits& upper, const StreetTraits& lower);

inline constexpr double kClearM = 4.5;      ///< above lanes and rails
inline constexpr double kRailTopM = 0.55;   ///< above the formation
inline constexpr double kRoadDeckM = 1.2;   ///< of a bridge of a road, below its surface
inline constexpr double kTrackDeckM = 0.9;  ///< of a bridge of a railway, below the formation
inline constexpr double kTunnelRoofM = 7.2; ///< from a road to the ground above its tube
inline constexpr double kRoundingM = 1.1;   ///< that smoothing takes of a rise

/// The shares of two lines, a to b and c to d, at which they cross; nothing: they do not.
std::optional<glm::dvec2> crossingShares(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 d);

/// The sine of the angle between two directions.
double sineBetween(glm::dvec2 a, glm::dvec2 b);

/// Finds where pieces of streets cross in the plan without a point in common; aboveOf() tells which one is
/// above.
/// `places`: of the map's nodes. Cost: near-linear in the number of pieces (a grid).
Overpasses overpassesOf(const StreetGraph& graph, const std::vector<glm::dvec2>& places,
                        const std::vector<CentreLine>& lines);

} // namespace worldmaking
