// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "worldmaking/streets/CentreLine.h"
#include "worldmaking/streets/Mouths.h"
#include "worldmaking/streets/StreetHeights.h"

namespace worldmaking
{

/// What notes tell of. All must outlive the call.
struct CrossingFacts
{
    const StreetGraph& graph;
    const std::vector<CentreLine>& lines;
    const std::vector<ChainCut>& cuts;
    const Crossings& crossings;
    const StreetHeights& heights;
    std::function<std::string(const glm::dvec2& plan)> placeText; ///< in degrees
    std::function<std::int64_t(std::size_t shape)> trackId;       ///< of the map
};

/// Returns a line for each crossing whose ways lie too close above each other, each tunnel that the ground
/// does not cover, and each crossing that the map leaves open: where, which ways, what is wrong, the remedy.
/// After kMostNotes of a kind their number alone.
std::vector<std::string> crossingNotes(const CrossingFacts& facts);

inline constexpr std::size_t kMostNotes = 10;

} // namespace worldmaking
