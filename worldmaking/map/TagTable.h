// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace worldmaking
{

/// What becomes of a tag of a map.
enum class TagUse
{
    read,
    approximated,
    ignored,
};

/// What its value is.
enum class TagValue
{
    word,
    metres,
    speed,
    number,
};

/// A tag of a map that is known.
struct KnownTag
{
    std::string_view key;
    TagUse use = TagUse::read;
    TagValue value = TagValue::word;
};

/// The tags of docs/reference/map-tags.md, in its order (a test compares them).
std::span<const KnownTag> knownTags();

/// Whether a value can be read as what it should be; words always can.
bool isReadable(const KnownTag& tag, std::string_view value);

} // namespace worldmaking
