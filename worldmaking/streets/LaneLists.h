// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// For whom a lane is.
enum class LaneUse : std::uint8_t
{
    cars,
    buses,
    bicycles,
    others, ///< not for cars, and the map does not say for whom: trams, taxis
};

/// Returns the entries of a list by lanes ("a|b"), from left to right as its drivers see the lanes; empty: no
/// such tag.
std::vector<std::string_view> laneEntries(const Tags& tags, const std::string& key);

/// Returns for whom each lane of a direction is by its lists of access; empty: the map has none. Of the
/// lists for cars the most special one that has an entry decides, as `motorcar:lanes` before
/// `vehicle:lanes`. `side`: "", ":forward", ":backward".
/// Source: the OpenStreetMap wiki, *Lanes*, *Key:access*, *Bus lanes*.
std::vector<LaneUse> laneUsesOf(const Tags& tags, const std::string& side);

/// The lanes that are not for bicycles, which `lanes` does not count.
std::vector<LaneUse> withoutBicycles(std::vector<LaneUse> uses);

inline constexpr std::size_t kMostListed = 12; ///< entries of a list; longer ones are slips

} // namespace worldmaking
