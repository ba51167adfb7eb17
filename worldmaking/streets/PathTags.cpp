// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/PathTags.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

bool isFootway(const Tags& tags)
{
    constexpr std::array<std::string_view, 7> kKinds{"path",      "footway", "cycleway",  "track",
                                                     "bridleway", "steps",   "pedestrian"};
    return std::find(kKinds.begin(), kKinds.end(), valueOf(tags, "highway")) != kKinds.end() ||
           isClosedStreet(tags);
}

} // namespace worldmaking
