// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// What the tags of a node on a street say about who waits there.
struct WaitTags
{
    bool isLight = false;     ///< vehicles have a traffic light
    bool isFootLight = false; ///< people on foot who cross have one
    bool isStop = false, givesWay = false;
    int direction = 0; ///< for whom: 1 along the way, -1 against it, 0 not told, or both

    bool isEmpty() const { return !isLight && !isFootLight && !isStop && !givesWay; }
};

/// Reads the tags of a node. Lights that only blink, or are dark most of the time (for fire engines), are
/// none. Source: the OpenStreetMap wiki, *Tag:highway=traffic_signals*, *Tag:crossing=traffic_signals*,
/// *Tag:highway=stop*, *Tag:highway=give_way*.
WaitTags waitTagsOf(const Tags& tags);

} // namespace worldmaking
