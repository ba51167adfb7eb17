// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "worldmaking/map/TagCounts.h"

namespace worldmaking
{

/// Which way traffic goes on a street.
enum class StreetDirection
{
    both,
    along,    ///< one way, as the map draws it
    against,  ///< one way, against the drawing
    changing, ///< one way at a time
};

/// Some of the lanes of a direction: bit 0 is the innermost.
using LaneSet = std::uint32_t;

/// The outermost `count` of `lanes`.
constexpr LaneSet outermostLanes(int count, int lanes)
{
    const int some = std::clamp(count, 0, lanes);
    return ((LaneSet{1} << static_cast<unsigned>(some)) - 1) << static_cast<unsigned>(lanes - some);
}

/// The lanes of a street, seen along its way. Those for buses are among the others.
struct LaneCounts
{
    int forward = 1, backward = 1;
    int shared = 0; ///< in the middle, for both directions: a single track, a lane for turns to the left
    LaneSet forwardBus = 0, backwardBus = 0;
};

inline constexpr int kMostLanes = 6; ///< in each direction

/// Returns which way cars go: by `oneway` and its keys for vehicles, and what `kind` and `junction` imply.
/// `approximated`: counts values that are taken for something else; may be null, here and below.
StreetDirection directionOf(const Tags& tags, std::string_view kind, TagCounts* approximated = nullptr);

/// Returns the lanes of a street. `usual`: in each direction, where no tag says it. `isNarrow`: too narrow
/// for two. A lane against a one-way street is one for buses; so are those that are closed to cars. Source:
/// the OpenStreetMap wiki, *Key:lanes*,
/// *Key:oneway*, *Key:busway*, *Lanes*.
LaneCounts lanesOfTags(const Tags& tags, StreetDirection direction, int usual, bool isNarrow,
                       TagCounts* approximated = nullptr);

/// How bicycles ride along a side of a street.
enum class CycleWay : std::uint8_t
{
    none,
    lane,  ///< a strip of the carriageway, beyond a line
    track, ///< beside it, behind a kerb
};

/// Returns the cycle lanes of a street on its sides, seen along its way: right, left. Of a one-way street
/// `cycleway` without a side is on the right. Where no such tag says it, a lane for bicycles at the edge of a
/// list by lanes (LaneLists.h) is one. Source: the OpenStreetMap wiki, *Key:cycleway*.
std::pair<CycleWay, CycleWay> cycleWaysOf(const Tags& tags, StreetDirection direction);

/// Returns the arrows of the lanes of a direction from left to right, as `turn:lanes` has them ("left",
/// "through;right", "": none); on lanes for buses those of `turn:bus:lanes`. `isForward`: along the way.
/// Nothing where the number of entries, without lanes for bicycles, is not `lanes`. Source: the OpenStreetMap
/// wiki, *Key:turn*, *Key:turn:bus:lanes*.
std::vector<std::string> turnArrowsOf(const Tags& tags, StreetDirection direction, bool isForward, int lanes);

} // namespace worldmaking
