// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/madeup/RoadSearch.h"
#include "worldmaking/madeup/Settlements.h"
#include "worldmaking/madeup/WayWeb.h"

namespace worldmaking
{

/// Pairs of settlements that a road joins: neighbours of which no third lies within the circle over the line
/// between them. All settlements hang together by them. Source: Gabriel & Sokal, *A new statistical approach
/// to geographic variation analysis*, 1969.
std::vector<std::pair<std::size_t, std::size_t>> neighboursOf(const std::vector<Settlement>& settlements);

/// Builds the roads between settlements: the most important and shortest pairs first; a later road follows
/// those that are there and leaves them at a right angle. `web` gets the roads. Returns how many settlements
/// no road reaches.
std::size_t planRoads(const std::vector<Settlement>& settlements, RoadSearch& search, WayWeb& web);

/// Builds one road from a place to the nearest of the web, by the search. False: no way leads there.
bool joinToWeb(const glm::dvec2& from, std::string_view kind, RoadSearch& search, WayWeb& web);

} // namespace worldmaking
