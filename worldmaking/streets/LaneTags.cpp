// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/LaneTags.h"

#include <algorithm>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>

#include <foundation/TagQuantity.h>

namespace worldmaking
{

namespace
{

bool isWordOf(std::string_view value, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), value) != words.end();
}

/// Reads the lane tags of one street.
class LaneTagReader
{
public:
    LaneTagReader(const Tags& tags, TagCounts* approximated) : _tags(tags), _approximated(approximated) {}

    /// A count of lanes; a value that is no whole number is rounded down.
    std::optional<int> count(std::string_view key) const
    {
        const std::string_view text = valueOf(_tags, key);
        if (text.empty()) return std::nullopt;
        const auto number = foundation::numberOfTag(text);
        if (!number || !(*number >= 1.0 && *number < 2.0 * kMostLanes + 1.0)) return std::nullopt;
        int whole = 0;
        const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), whole);
        if (failure != std::errc() || end != text.data() + text.size()) told(key);
        return static_cast<int>(*number);
    }

    /// How many lanes a direction has; `side`: "", ":forward", ":backward", ":both_ways". Where no number
    /// says it, a list has an entry for each.
    std::optional<int> lanes(const std::string& side) const
    {
        if (const auto told = count("lanes" + side)) return told;
        for (const char* key : {"turn:lanes", "change:lanes", "width:lanes"})
            if (const std::string_view list = valueOf(_tags, key + side); !list.empty())
            {
                const auto entries = 1 + std::count(list.begin(), list.end(), '|');
                if (entries <= 2 * kMostLanes) return static_cast<int>(entries);
            }
        return std::nullopt;
    }

    /// Lanes for buses of a direction, by number.
    int buses(const std::string& side) const
    {
        for (const char* key : {"lanes:psv", "lanes:bus"})
            if (const auto told = count(key + side)) return *told;
        return 0;
    }

    bool is(std::string_view key, std::initializer_list<std::string_view> values) const
    {
        return isWordOf(valueOf(_tags, key), values);
    }

    bool has(std::string_view key) const { return !valueOf(_tags, key).empty(); }

    void told(std::string_view key) const { countTag(_approximated, _tags, key); }

private:
    const Tags& _tags;
    TagCounts* _approximated;
};

/// Whether buses go against a one-way street. `back`: the side of its lanes.
bool hasBusesAgainst(const LaneTagReader& reader, const std::string& back)
{
    for (const char* key : {"oneway:bus", "oneway:psv", "oneway:tourist_bus"})
        if (reader.is(key, {"no", "-1"})) return true;
    for (const char* key : {"busway", "busway:left", "busway:right", "busway:both"})
        if (reader.is(key, {"opposite_lane", "opposite", "opposite_track"})) return true;
    return reader.buses(back) > 0 || reader.has("bus:lanes" + back) || reader.has("psv:lanes" + back);
}

LaneCounts onewayLanes(const LaneTagReader& reader, bool isAlong, int usual)
{
    const std::string ahead = isAlong ? ":forward" : ":backward", back = isAlong ? ":backward" : ":forward";
    const auto all = reader.lanes(""), with = reader.lanes(ahead), against = reader.lanes(back);
    int lanesBack = 0;
    if (hasBusesAgainst(reader, back))
        lanesBack = against.value_or(all ? std::min(1, *all - 1) : 1);
    else if (against)
        reader.told("lanes" + back); // that of a one-way street
    LaneCounts lanes;
    lanes.forward = with.value_or(all ? std::max(1, *all - lanesBack) : usual);
    lanes.backward = lanes.backwardBus = lanesBack;
    lanes.forwardBus = std::max(reader.buses(ahead), reader.buses(""));
    if (!isAlong) std::swap(lanes.forward, lanes.backward), std::swap(lanes.forwardBus, lanes.backwardBus);
    return lanes;
}

LaneCounts twoWayLanes(const LaneTagReader& reader, int usual, bool isNarrow)
{
    const auto all = reader.lanes(""), forward = reader.lanes(":forward"),
               backward = reader.lanes(":backward"), both = reader.lanes(":both_ways");
    const bool hasTurnLane = reader.is("centre_turn_lane", {"yes"}) || reader.is("center_turn_lane", {"yes"});
    LaneCounts lanes;
    lanes.shared = std::min(both.value_or(hasTurnLane ? 1 : 0), 2);
    const int rest = all ? *all - lanes.shared : 0;
    const bool isSingle = all ? rest <= 1 : isNarrow;
    if (forward && backward)
        lanes.forward = *forward, lanes.backward = *backward;
    else if (isSingle)
        return {0, 0, 1, 0, 0};
    else if (forward)
        lanes.forward = *forward, lanes.backward = all ? std::max(1, rest - *forward) : usual;
    else if (backward)
        lanes.backward = *backward, lanes.forward = all ? std::max(1, rest - *backward) : usual;
    else
        lanes.forward = all ? (rest + 1) / 2 : usual, lanes.backward = all ? rest / 2 : usual;
    lanes.forwardBus = reader.buses(":forward");
    lanes.backwardBus = reader.buses(":backward");
    return lanes;
}

} // namespace

StreetDirection directionOf(const Tags& tags, std::string_view kind, TagCounts* approximated)
{
    // The most special key that says anything decides.
    for (const std::string_view key : {"oneway:motorcar", "oneway:motor_vehicle", "oneway:vehicle", "oneway"})
    {
        const std::string_view value = valueOf(tags, key);
        if (isWordOf(value, {"yes", "true", "1"})) return StreetDirection::along;
        if (isWordOf(value, {"-1", "reverse"})) return StreetDirection::against;
        if (isWordOf(value, {"no", "false", "0"})) return StreetDirection::both;
        if (!value.empty()) countTag(approximated, tags, key);
        if (isWordOf(value, {"reversible", "alternating"})) return StreetDirection::changing;
    }
    const bool isRing = isWordOf(valueOf(tags, "junction"), {"roundabout", "circular"});
    return isRing || kind == "motorway" ? StreetDirection::along : StreetDirection::both;
}

LaneCounts lanesOfTags(const Tags& tags, StreetDirection direction, int usual, bool isNarrow,
                       TagCounts* approximated)
{
    const LaneTagReader reader(tags, approximated);
    LaneCounts lanes;
    if (direction == StreetDirection::changing)
        lanes = {0, 0, std::min(reader.lanes("").value_or(usual), kMostLanes), 0, 0};
    else if (direction == StreetDirection::both)
        lanes = twoWayLanes(reader, usual, isNarrow);
    else
        lanes = onewayLanes(reader, direction == StreetDirection::along, usual);
    for (int* count : {&lanes.forward, &lanes.backward})
        *count = std::min(*count, kMostLanes);
    lanes.forwardBus = std::min(lanes.forwardBus, lanes.forward);
    lanes.backwardBus = std::min(lanes.backwardBus, lanes.backward);
    return lanes;
}

} // namespace worldmaking
