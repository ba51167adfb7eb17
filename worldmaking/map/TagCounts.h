// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>

#include <foundation/Excerpt.h>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// Tags as "key=value", and how often each was met.
using TagCounts = std::map<std::string, std::size_t, std::less<>>;

inline constexpr std::size_t kMostTagCounts = 32; ///< others count as "(others)"

/// Counts the tag of a key. `counts`: may be null.
inline void countTag(TagCounts* counts, const Tags& tags, std::string_view key)
{
    if (!counts) return;
    constexpr std::size_t kMostBytes = 60;
    const std::string name = std::string(key) + "=" + foundation::excerpt(valueOf(tags, key), kMostBytes);
    const bool isKnown = counts->size() < kMostTagCounts || counts->contains(name);
    ++(*counts)[isKnown ? name : "(others)"];
}

} // namespace worldmaking
