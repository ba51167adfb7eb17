// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace worldmaking
{

/// Water that flows from place to place: nodes with the height of the ground there, edges downstream. A lake
/// is one node.
struct WaterNet
{
    std::vector<double> groundM;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> flows; ///< from, to
    std::vector<double> flowsM; ///< how long each of them is; empty: not known
};

/// Returns the level of each node: no level is higher than one upstream. Between two such levels, the highest
/// that need no bank (the ground is cut through) and the lowest that need no cut (the ground is filled up),
/// kCutShare from the second to the first. Circles in the net are level.
/// Source: Lindsay, *Efficient hybrid breaching-filling sink removal methods for flow path enforcement in
/// digital elevation models*,
/// 2016. Differs: along a given net. Cost: O(n log n).
std::vector<double> waterLevels(const WaterNet& net);

/// Spreads falls along the way: lowers levels upstream of them until no flow is steeper than kRiverGrade, by
/// kMostSpreadM at most, since steep ground is more often real than a step of coarse elevation data. No level
/// comes to lie higher than one upstream. Needs flowsM.
/// Source: Dijkstra, *A note on two problems in connexion with graphs*, 1959, upstream from the lowest. Cost:
/// O(n log n).
std::vector<double> spreadFalls(const WaterNet& net, const std::vector<double>& levels);

inline constexpr double kRiverGrade = 0.07, kMostSpreadM = 5.0;
inline constexpr double kCutShare =
    0.95; ///< a bump of elevation data is more often a tree or a bridge than a dam

} // namespace worldmaking
