// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

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

/// The lanes of a street, seen along its way. Those for buses are among the others, outermost.
struct LaneCounts
{
    int forward = 1, backward = 1;
    int shared = 0; ///< in the middle, for both directions: a single track, a lane for turns to the left
    int forwardBus = 0, backwardBus = 0;
};

inline constexpr int kMostLanes = 6; ///< in each direction

/// Returns which way cars go: by `oneway` and its keys for vehicles, and what `kind` and `junction` imply.
/// `approximated`: counts values that are taken for something else; may be null, here and below.
StreetDirection directionOf(const Tags& tags, std::string_view kind, TagCounts* approximated = nullptr);

/// Returns the lanes of a street. `usual`: in each direction, where no tag says it. `isNarrow`: too narrow
/// for two. A lane against a one-way street is one for buses. Source: the OpenStreetMap wiki, *Key:lanes*,
/// *Key:oneway*, *Key:busway*, *Lanes*.
LaneCounts lanesOfTags(const Tags& tags, StreetDirection direction, int usual, bool isNarrow,
                       TagCounts* approximated = nullptr);

} // namespace worldmaking
