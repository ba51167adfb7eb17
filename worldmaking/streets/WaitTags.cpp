// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/WaitTags.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace worldmaking
{

namespace
{

/// Whether a list of values, parted by semicolons, has one.
bool hasValue(std::string_view list, std::string_view value)
{
    for (std::size_t from = 0; from <= list.size();)
    {
        const std::size_t to = std::min(list.find(';', from), list.size());
        std::string_view one = list.substr(from, to - from);
        while (one.starts_with(' '))
            one.remove_prefix(1);
        while (one.ends_with(' '))
            one.remove_suffix(1);
        if (one == value) return true;
        from = to + 1;
    }
    return false;
}

} // namespace

WaitTags waitTagsOf(const Tags& tags)
{
    constexpr std::array<std::string_view, 5> kNoLights{"blinker", "blink_mode", "emergency", "ramp_meter",
                                                        "no"};
    const std::string_view kind = valueOf(tags, "highway");
    const std::string_view light = valueOf(tags, "traffic_signals");
    WaitTags waits;
    waits.isLight = hasValue(kind, "traffic_signals") &&
                    std::find(kNoLights.begin(), kNoLights.end(), light) == kNoLights.end();
    const bool isCrossing = waits.isLight || hasValue(kind, "crossing");
    waits.isFootLight = isCrossing && (hasValue(valueOf(tags, "crossing"), "traffic_signals") ||
                                       valueOf(tags, "crossing:signals") == "yes" ||
                                       (waits.isLight && light == "pedestrian_crossing"));
    waits.isStop = hasValue(kind, "stop");
    waits.givesWay = hasValue(kind, "give_way");
    std::string_view direction = valueOf(tags, "traffic_signals:direction");
    if (direction.empty() || !waits.isLight) direction = valueOf(tags, "direction");
    waits.direction = direction == "forward" ? 1 : direction == "backward" ? -1 : 0;
    return waits;
}

} // namespace worldmaking
