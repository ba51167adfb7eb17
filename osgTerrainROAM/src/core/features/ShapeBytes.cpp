// SPDX-License-Identifier: Apache-2.0
#include "ShapeBytes.h"

#include <foundation/PlainBytes.h>

#include "PathBytes.h"

namespace osgTerrainROAM::core
{

namespace
{

using foundation::appendValue;
using foundation::ValueTaker;
using Tags = std::map<std::string, std::string, std::less<>>;

constexpr std::size_t kLeastBytes = 8; ///< of anything that is counted

void appendTags(std::string& bytes, const Tags& tags)
{
    appendValue(bytes, static_cast<std::uint64_t>(tags.size()));
    for (const auto& [key, value] : tags)
    {
        foundation::appendText(bytes, key);
        foundation::appendText(bytes, value);
    }
}

/// Tags were written in their order: each goes behind the one before.
bool takeTags(ValueTaker& taker, Tags& tags)
{
    std::uint64_t count = 0;
    if (!taker.takeCount(count, 2 * kLeastBytes)) return false;
    std::string key, value;
    for (; count > 0; --count)
    {
        if (!taker.take(key) || !taker.take(value)) return false;
        tags.emplace_hint(tags.end(), std::move(key), std::move(value));
    }
    return true;
}

bool takeShape(ValueTaker& taker, MapShape& shape)
{
    return taker.take(shape.id) && taker.take(shape.point) && takePaths(taker, shape.rings) &&
           takeTags(taker, shape.tags);
}

bool takeMapLine(ValueTaker& taker, MapLine& line)
{
    return taker.take(line.id) && taker.take(line.points) && takeTags(taker, line.tags);
}

} // namespace

std::string bytesOf(const ShapeSet& set)
{
    std::string bytes;
    for (const std::size_t count : {set.lines, set.outside, set.invalid, set.shapes.size()})
        appendValue(bytes, static_cast<std::uint64_t>(count));
    for (const MapShape& shape : set.shapes)
    {
        appendValue(bytes, shape.id);
        appendValue(bytes, shape.point);
        appendPaths(bytes, shape.rings);
        appendTags(bytes, shape.tags);
    }
    appendValue(bytes, static_cast<std::uint64_t>(set.linear.size()));
    for (const MapLine& line : set.linear)
    {
        appendValue(bytes, line.id);
        foundation::appendValues(bytes, line.points);
        appendTags(bytes, line.tags);
    }
    foundation::appendTexts(bytes, set.notes);
    return bytes;
}

std::optional<ShapeSet> shapesIn(std::string_view bytes)
{
    ShapeSet set;
    ValueTaker taker(bytes);
    std::uint64_t lines = 0, outside = 0, invalid = 0, count = 0;
    if (!taker.take(lines) || !taker.take(outside) || !taker.take(invalid) ||
        !taker.takeCount(count, kLeastBytes))
        return std::nullopt;
    set.lines = static_cast<std::size_t>(lines);
    set.outside = static_cast<std::size_t>(outside);
    set.invalid = static_cast<std::size_t>(invalid);
    set.shapes.resize(static_cast<std::size_t>(count));
    for (MapShape& shape : set.shapes)
        if (!takeShape(taker, shape)) return std::nullopt;
    if (!taker.takeCount(count, kLeastBytes)) return std::nullopt;
    set.linear.resize(static_cast<std::size_t>(count));
    for (MapLine& line : set.linear)
        if (!takeMapLine(taker, line)) return std::nullopt;
    return taker.take(set.notes) && taker.isEmpty() ? std::optional(std::move(set)) : std::nullopt;
}

} // namespace osgTerrainROAM::core
