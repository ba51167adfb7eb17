// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/LaneTags.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <foundation/TagQuantity.h>

#include "worldmaking/streets/LaneLists.h"

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
    /// says it, a list has an entry for each, and for those of bicycles.
    std::optional<int> lanes(const std::string& side) const
    {
        if (const auto told = count("lanes" + side)) return told;
        for (const char* key :
             {"turn:lanes", "change:lanes", "width:lanes", "bus:lanes", "psv:lanes", "motorcar:lanes",
              "motor_vehicle:lanes", "vehicle:lanes", "access:lanes", "turn:bus:lanes"})
        {
            const std::size_t entries = laneEntries(_tags, key + side).size();
            if (entries == 0 || entries > kMostListed) continue;
            const auto uses = laneUsesOf(_tags, side);
            const auto all = uses.size() == entries ? withoutBicycles(uses).size() : entries;
            if (all > 0) return static_cast<int>(all);
        }
        return std::nullopt;
    }

    /// Lanes for buses of a direction of so many lanes: the outermost by number, or those of the entries of
    /// lists that are theirs, or that are closed to cars.
    LaneSet buses(const std::string& side, int lanes) const
    {
        for (const char* key : {"lanes:psv", "lanes:bus"})
            if (const auto told = count(key + side)) return outermostLanes(*told, lanes);
        const auto listed = laneUsesOf(_tags, side), driven = withoutBicycles(listed);
        const auto size = static_cast<std::size_t>(std::max(lanes, 0));
        if (driven.size() == size) return busesOf(driven);
        if (listed.size() == size) return busesOf(listed); // lanes for cars and bicycles
        // Lists count lanes for bicycles, too, which `lanes` does not.
        const auto all = LaneTagReader(_tags, nullptr).count("lanes" + side); // told elsewhere
        const int beyond = all ? std::max(0, static_cast<int>(driven.size()) - *all) : 0;
        return outermostLanes(std::popcount(busesOf(driven)) - beyond, lanes);
    }

    /// Whether a list names a lane of a direction as one for buses.
    bool listsBuses(const std::string& side) const
    {
        const auto uses = laneUsesOf(_tags, side);
        return std::find(uses.begin(), uses.end(), LaneUse::buses) != uses.end();
    }

    /// Whether a lane for buses runs on a side (`busway`): "right" or "left".
    bool hasBusway(const char* side) const
    {
        const auto isLane = [&](const std::string& key) { return is(key, {"lane"}); };
        return isLane("busway") || isLane("busway:both") || isLane(std::string("busway:") + side);
    }

    bool is(std::string_view key, std::initializer_list<std::string_view> values) const
    {
        return isWordOf(valueOf(_tags, key), values);
    }

    bool has(std::string_view key) const { return !valueOf(_tags, key).empty(); }

    void told(std::string_view key) const { countTag(_approximated, _tags, key); }

private:
    static LaneSet busesOf(const std::vector<LaneUse>& uses)
    {
        LaneSet theirs = 0;
        for (std::size_t i = 0; i < uses.size(); ++i)
            if (uses[i] == LaneUse::buses || uses[i] == LaneUse::others) theirs |= LaneSet{1} << i;
        return theirs;
    }

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
    return reader.count("lanes:psv" + back) || reader.count("lanes:bus" + back) || reader.listsBuses(back) ||
           reader.has("bus:lanes" + back) || reader.has("psv:lanes" + back);
}

/// Takes lanes of `busway`, where no other tag tells lanes for buses: a direction keeps a lane for cars.
void addBusway(bool hasOne, int& lanes, LaneSet& buses)
{
    if (!hasOne || buses != 0 || lanes == 0) return;
    lanes = std::max(lanes, 2);
    buses = outermostLanes(1, lanes);
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
    lanes.forward = std::min(with.value_or(all ? std::max(1, *all - lanesBack) : usual), kMostLanes);
    lanes.backward = std::min(lanesBack, kMostLanes);
    lanes.backwardBus = outermostLanes(lanes.backward, lanes.backward);
    const LaneSet ofSide = reader.buses(ahead, lanes.forward), ofStreet = reader.buses("", lanes.forward);
    lanes.forwardBus = std::popcount(ofSide) >= std::popcount(ofStreet) ? ofSide : ofStreet;
    addBusway(reader.hasBusway("right") || reader.hasBusway("left"), lanes.forward, lanes.forwardBus);
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
    for (int* count : {&lanes.forward, &lanes.backward})
        *count = std::min(*count, kMostLanes);
    lanes.forwardBus = reader.buses(":forward", lanes.forward);
    lanes.backwardBus = reader.buses(":backward", lanes.backward);
    if ((lanes.forwardBus | lanes.backwardBus) == 0) // of both directions together
    {
        const int buses = std::popcount(reader.buses("", 2 * kMostLanes));
        lanes.forwardBus =
            outermostLanes(std::min((buses + 1) / 2, std::max(0, lanes.forward - 1)), lanes.forward);
        lanes.backwardBus =
            outermostLanes(std::min(buses / 2, std::max(0, lanes.backward - 1)), lanes.backward);
    }
    addBusway(reader.hasBusway("right"), lanes.forward, lanes.forwardBus);
    addBusway(reader.hasBusway("left"), lanes.backward, lanes.backwardBus);
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
    return lanes;
}

std::pair<CycleWay, CycleWay> cycleWaysOf(const Tags& tags, StreetDirection direction)
{
    const auto kindOf = [&](std::string_view key)
    {
        const std::string_view value = valueOf(tags, key);
        if (isWordOf(value, {"lane", "opposite_lane"})) return CycleWay::lane;
        return isWordOf(value, {"track", "opposite_track"}) ? CycleWay::track : CycleWay::none;
    };
    const auto sideOf = [&](std::string_view side, bool hasPlain)
    {
        for (const std::string_view key : {side, std::string_view("cycleway:both")})
            if (const CycleWay kind = kindOf(key); kind != CycleWay::none) return kind;
        return hasPlain && valueOf(tags, side).empty() ? kindOf("cycleway") : CycleWay::none;
    };
    // A lane for bicycles at the edge of a list by lanes.
    const auto listed = [&](const std::string& ofDirection, bool isAtRight)
    {
        const auto uses = laneUsesOf(tags, ofDirection);
        const bool isThere = uses.size() > 1 && (isAtRight ? uses.back() : uses.front()) == LaneUse::bicycles;
        const auto lanes = foundation::numberOfTag(valueOf(tags, "lanes" + ofDirection));
        return isThere && (!lanes || *lanes <= static_cast<double>(withoutBicycles(uses).size()));
    };
    const bool isOpposite = valueOf(tags, "cycleway").starts_with("opposite");
    const bool isRightAlone = direction == StreetDirection::along && !isOpposite,
               isLeftAlone = (direction == StreetDirection::along && isOpposite) ||
                             (direction == StreetDirection::against && !isOpposite);
    std::pair<CycleWay, CycleWay> sides{sideOf("cycleway:right", !isLeftAlone),
                                        sideOf("cycleway:left", !isRightAlone)};
    const bool isAgainst = direction == StreetDirection::against, isBoth = direction == StreetDirection::both;
    const auto take = [](CycleWay& side, bool isListed)
    {
        if (isListed && side == CycleWay::none) side = CycleWay::lane;
    };
    take(sides.first, listed(":forward", true) || (!isBoth && listed("", !isAgainst)));
    take(sides.second, listed(":backward", true) || (!isBoth && listed("", isAgainst)));
    return sides;
}

std::vector<std::string> turnArrowsOf(const Tags& tags, StreetDirection direction, bool isForward, int lanes)
{
    const bool isOneway = direction == (isForward ? StreetDirection::along : StreetDirection::against);
    std::string side = isForward ? ":forward" : ":backward";
    const auto has = [&](const char* key) { return !valueOf(tags, key + side).empty(); };
    if (!has("turn:lanes") && !has("turn:bus:lanes") && isOneway) side.clear();
    auto entries = laneEntries(tags, "turn:lanes" + side);
    auto uses = laneUsesOf(tags, side);
    if (const auto ofBuses = laneEntries(tags, "turn:bus:lanes" + side); !ofBuses.empty())
    {
        if (entries.empty()) entries.resize(ofBuses.size());
        for (std::size_t i = 0; i < std::min({entries.size(), ofBuses.size(), uses.size()}); ++i)
            if (uses[i] == LaneUse::buses && !ofBuses[i].empty()) entries[i] = ofBuses[i];
    }
    if (entries.empty() && lanes == 1 && isOneway) entries = laneEntries(tags, "turn");
    const auto driven = static_cast<std::size_t>(std::max(lanes, 0));
    if (uses.size() == entries.size() && withoutBicycles(uses).size() == driven)
        for (std::size_t i = uses.size(); i-- > 0;)
            if (uses[i] == LaneUse::bicycles) entries.erase(entries.begin() + static_cast<std::ptrdiff_t>(i));
    std::vector<std::string> arrows;
    while (entries.size() > driven && (entries.back().empty() || entries.back() == "none"))
        entries.pop_back(); // lanes for bicycles
    if (lanes < 1 || entries.size() != driven) return arrows;
    bool hasOne = false;
    for (const std::string_view entry : entries)
    {
        arrows.emplace_back(entry == "none" ? std::string_view() : entry);
        hasOne = hasOne || !arrows.back().empty();
    }
    return hasOne ? arrows : std::vector<std::string>();
}

} // namespace worldmaking
