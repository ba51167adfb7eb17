// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetTraits.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>

namespace worldmaking
{

namespace
{

/// What a class of streets has where its tags say nothing.
struct StreetClass
{
    std::string_view kind;
    std::string_view roadType;
    int importance;
    int lanes; ///< in each direction
    double laneWidthM, shoulderM, speedKmh, steepest;
    bool hasCentreMark, hasEdgeMarks;
};

constexpr std::array<StreetClass, 10> kClasses = {{
    {"motorway", "motorway", 8, 2, 3.75, 2.5, 120.0, 0.07, true, true},
    {"trunk", "rural", 7, 1, 3.5, 0.5, 90.0, 0.08, true, true},
    {"primary", "rural", 6, 1, 3.5, 0.5, 80.0, 0.10, true, true},
    {"secondary", "rural", 5, 1, 3.25, 0.25, 70.0, 0.12, true, true},
    {"tertiary", "rural", 4, 1, 3.0, 0.25, 60.0, 0.12, true, false},
    {"unclassified", "rural", 3, 1, 2.75, 0.25, 50.0, 0.15, false, false},
    {"residential", "town", 2, 1, 2.75, 0.0, 40.0, 0.15, false, false},
    {"road", "rural", 2, 1, 2.75, 0.0, 40.0, 0.15, false, false},
    {"living_street", "lowSpeed", 1, 1, 2.5, 0.0, 20.0, 0.15, false, false},
    {"service", "lowSpeed", 0, 1, 2.5, 0.0, 20.0, 0.15, false, false},
}};

constexpr int kMostLanes = 6;

const StreetClass* classOf(std::string_view kind)
{
    const auto found = std::find_if(kClasses.begin(), kClasses.end(),
                                    [&](const StreetClass& entry) { return entry.kind == kind; });
    return found == kClasses.end() ? nullptr : &*found;
}

std::optional<int> countOf(const Tags& tags, std::string_view key)
{
    const std::string_view text = valueOf(tags, key);
    int count = 0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
    if (text.empty() || read.ec != std::errc() || count < 1 || count > 2 * kMostLanes) return std::nullopt;
    return count;
}

std::optional<double> speedOf(const Tags& tags)
{
    const std::string_view text = valueOf(tags, "maxspeed");
    double speed = 0.0;
    const auto read = std::from_chars(text.data(), text.data() + text.size(), speed);
    if (read.ec != std::errc() || !(speed >= 5.0 && speed <= 150.0)) return std::nullopt;
    return text.ends_with("mph") ? speed * 1.609344 : speed;
}

bool isAmong(std::string_view value, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), value) != words.end();
}

bool isClosedToCars(const Tags& tags)
{
    if (valueOf(tags, "area") == "yes") return true;
    // The most special key that says anything decides.
    for (const std::string_view key : {"motorcar", "motor_vehicle", "vehicle", "access"})
        if (const std::string_view value = valueOf(tags, key); !value.empty()) return value == "no";
    return false;
}

/// 1: along the way; -1: against it; 0: both.
int directionOf(const Tags& tags, std::string_view kind)
{
    const std::string_view value = valueOf(tags, "oneway");
    if (isAmong(value, {"yes", "true", "1", "reversible", "alternating"})) return 1;
    if (isAmong(value, {"-1", "reverse"})) return -1;
    if (isAmong(value, {"no", "false", "0"})) return 0;
    const bool isRing = isAmong(valueOf(tags, "junction"), {"roundabout", "circular"});
    return isRing || kind == "motorway" ? 1 : 0;
}

void setLanes(const Tags& tags, int direction, int usual, StreetTraits& traits)
{
    const auto all = countOf(tags, "lanes");
    if (direction != 0)
    {
        const int lanes = std::min(all.value_or(usual), kMostLanes);
        traits.forwardLanes = direction > 0 ? lanes : 0;
        traits.backwardLanes = direction > 0 ? 0 : lanes;
        return;
    }
    int forward = usual, backward = usual;
    if (all) forward = std::max(1, (*all + 1) / 2), backward = std::max(1, *all / 2);
    if (const auto count = countOf(tags, "lanes:forward")) forward = *count;
    if (const auto count = countOf(tags, "lanes:backward")) backward = *count;
    traits.forwardLanes = std::min(forward, kMostLanes);
    traits.backwardLanes = std::min(backward, kMostLanes);
}

void setSidewalks(const Tags& tags, StreetTraits& traits)
{
    const std::string_view value = valueOf(tags, "sidewalk");
    const auto has = [&](std::string_view side, std::string_view key) {
        return isAmong(value, {"both", "yes", side}) || valueOf(tags, key) == "yes";
    };
    const bool both = valueOf(tags, "sidewalk:both") == "yes";
    traits.hasLeftSidewalk = both || has("left", "sidewalk:left");
    traits.hasRightSidewalk = both || has("right", "sidewalk:right");
}

StreetPlace placeOf(const Tags& tags)
{
    const std::string_view bridge = valueOf(tags, "bridge"), tunnel = valueOf(tags, "tunnel");
    // A passage through a house is at the level of the street.
    if (!tunnel.empty() && tunnel != "no" && tunnel != "building_passage") return StreetPlace::tunnel;
    if (!bridge.empty() && bridge != "no") return StreetPlace::bridge;
    return StreetPlace::ground;
}

} // namespace

StreetTraits StreetTraits::reversed() const
{
    StreetTraits other = *this;
    std::swap(other.forwardLanes, other.backwardLanes);
    std::swap(other.hasLeftSidewalk, other.hasRightSidewalk);
    return other;
}

bool StreetTraits::hasSameLanes(const StreetTraits& other) const
{
    return forwardLanes == other.forwardLanes && backwardLanes == other.backwardLanes &&
           laneWidthM == other.laneWidthM && shoulderM == other.shoulderM &&
           hasLeftSidewalk == other.hasLeftSidewalk && hasRightSidewalk == other.hasRightSidewalk &&
           hasCentreMark == other.hasCentreMark && hasEdgeMarks == other.hasEdgeMarks;
}

std::optional<StreetTraits> traitsOf(const Tags& tags)
{
    const std::string_view kind = valueOf(tags, "highway");
    const bool isLink = kind.ends_with("_link");
    const StreetClass* found = classOf(isLink ? kind.substr(0, kind.size() - 5) : kind);
    if (!found || isClosedToCars(tags)) return std::nullopt;
    StreetTraits traits;
    traits.name = valueOf(tags, "name");
    if (traits.name.empty()) traits.name = valueOf(tags, "ref");
    traits.kind = kind;
    traits.roadType = found->roadType;
    traits.importance = found->importance;
    traits.laneWidthM = found->laneWidthM;
    traits.shoulderM = found->shoulderM;
    traits.steepest = found->steepest;
    traits.speedKmh = speedOf(tags).value_or(isLink ? 0.6 * found->speedKmh : found->speedKmh);
    setLanes(tags, directionOf(tags, kind), isLink ? 1 : found->lanes, traits);
    setSidewalks(tags, traits);
    traits.hasCentreMark = found->hasCentreMark && traits.forwardLanes > 0 && traits.backwardLanes > 0;
    traits.hasEdgeMarks = found->hasEdgeMarks;
    traits.place = placeOf(tags);
    return traits;
}

} // namespace worldmaking
