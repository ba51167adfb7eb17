// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/StreetTraits.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <tuple>
#include <utility>

#include <foundation/TagQuantity.h>

#include "worldmaking/map/SpeedTags.h"
#include "worldmaking/streets/LaneTags.h"

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

constexpr std::array<StreetClass, 11> kClasses = {{
    {"motorway", "motorway", 8, 2, 3.75, 2.5, 120.0, 0.07, true, true},
    {"trunk", "rural", 7, 1, 3.5, 0.5, 90.0, 0.08, true, true},
    {"primary", "rural", 6, 1, 3.5, 0.5, 80.0, 0.10, true, true},
    {"secondary", "rural", 5, 1, 3.25, 0.25, 70.0, 0.12, true, true},
    {"tertiary", "rural", 4, 1, 3.0, 0.25, 60.0, 0.12, true, false},
    {"unclassified", "rural", 3, 1, 2.75, 0.25, 50.0, 0.15, false, false},
    {"residential", "town", 2, 1, 2.75, 0.0, 40.0, 0.15, false, false},
    {"road", "rural", 2, 1, 2.75, 0.0, 40.0, 0.15, false, false},
    {"living_street", "lowSpeed", 1, 1, 2.5, 0.0, 20.0, 0.15, false, false},
    {"busway", "town", 1, 1, 3.5, 0.0, 50.0, 0.12, false, false},
    {"service", "lowSpeed", 0, 1, 2.5, 0.0, 20.0, 0.15, false, false},
}};

const StreetClass* classOf(std::string_view kind)
{
    const auto found = std::find_if(kClasses.begin(), kClasses.end(),
                                    [&](const StreetClass& entry) { return entry.kind == kind; });
    return found == kClasses.end() ? nullptr : &*found;
}

bool isLinkKind(std::string_view kind)
{
    return kind.ends_with("_link");
}

/// The class of a value of `highway`; a link has that of its road.
const StreetClass* classOfWay(std::string_view kind)
{
    return classOf(isLinkKind(kind) ? kind.substr(0, kind.size() - 5) : kind);
}

bool isAmong(std::string_view value, std::initializer_list<std::string_view> words)
{
    return std::find(words.begin(), words.end(), value) != words.end();
}

/// A street that is yet to come, or is no more; an area.
bool isNoStreet(const Tags& tags)
{
    constexpr std::array<std::string_view, 7> kKeys{"proposed", "planned",    "abandoned", "disused",
                                                    "area",     "demolished", "razed"};
    return std::any_of(kKeys.begin(), kKeys.end(),
                       [&](std::string_view key) { return valueOf(tags, key) == "yes"; });
}

/// A street for buses alone: there is none for cars to miss.
bool isBusway(const Tags& tags)
{
    return valueOf(tags, "highway") == "busway";
}

/// Whether buses may use what is closed to cars.
bool isOpenToBuses(const Tags& tags)
{
    return isAmong(valueOf(tags, "bus"), {"yes", "designated", "official"}) ||
           isAmong(valueOf(tags, "psv"), {"yes", "designated", "official"});
}

/// Whether cars may not use it, by the most special key that says anything.
bool isClosedToCars(const Tags& tags)
{
    for (const std::string_view key : {"motorcar", "motor_vehicle", "vehicle", "access"})
        if (const std::string_view value = valueOf(tags, key); !value.empty()) return value == "no";
    return false;
}

/// Whether what it is for may not use it.
bool isClosed(const Tags& tags)
{
    if (valueOf(tags, "smoothness") == "impassable") return true;
    if (isBusway(tags)) return valueOf(tags, "bus") == "no" || valueOf(tags, "psv") == "no";
    return isClosedToCars(tags) && !isOpenToBuses(tags);
}

bool isUnpaved(std::string_view surface)
{
    return isAmong(surface, {"unpaved", "gravel", "fine_gravel", "compacted", "pebblestone", "ground", "dirt",
                             "earth", "grass", "mud", "sand", "rock", "soil", "dirt/sand", "grass_paver"});
}

/// The speed by the first key that tells one.
std::optional<double> speedOf(const Tags& tags, std::initializer_list<std::string_view> keys)
{
    for (const std::string_view key : keys)
        if (const auto speed = speedKmhOf(valueOf(tags, key))) return speed;
    return std::nullopt;
}

void setSpeeds(const Tags& tags, double defaultKmh, StreetTraits& traits)
{
    const auto ahead = speedOf(tags, {"maxspeed:forward"}), back = speedOf(tags, {"maxspeed:backward"});
    const auto all = speedOf(tags, {"maxspeed", "maxspeed:type", "source:maxspeed", "zone:maxspeed"});
    const double forward = ahead.value_or(all.value_or(defaultKmh)),
                 backward = back.value_or(all.value_or(defaultKmh));
    const bool hasForward = traits.forwardLanes + traits.sharedLanes > 0,
               hasBackward = traits.backwardLanes + traits.sharedLanes > 0;
    traits.speedKmh = std::max(hasForward ? forward : 0.0, hasBackward ? backward : 0.0);
    traits.forwardKmh = hasForward ? forward : traits.speedKmh;
    traits.backwardKmh = hasBackward ? backward : traits.speedKmh;
}

/// The paving between kerbs, where a tag tells it.
std::optional<double> pavingOf(const Tags& tags)
{
    constexpr double kLeastM = 1.5, kMostM = 60.0;
    for (const std::string_view key : {"width:carriageway", "width", "est_width"})
        if (const auto widthM = foundation::metresOfTag(valueOf(tags, key)))
            if (*widthM >= kLeastM && *widthM <= kMostM) return widthM;
    return std::nullopt;
}

void setLanes(const Tags& tags, std::string_view kind, int usual, StreetTraits& traits,
              TagCounts* approximated)
{
    constexpr double kNarrowM = 4.0;      // two cars do not pass
    constexpr double kSingleTrackM = 3.5; // where no tag says it
    constexpr double kLeastLaneM = 1.8, kMostLaneM = 6.0;
    const auto pavingM = pavingOf(tags);
    const StreetDirection direction = directionOf(tags, kind, approximated);
    const LaneCounts lanes =
        lanesOfTags(tags, direction, usual, pavingM && *pavingM < kNarrowM, approximated);
    traits.forwardLanes = lanes.forward;
    traits.backwardLanes = lanes.backward;
    traits.sharedLanes = lanes.shared;
    traits.forwardBusLanes = lanes.forwardBus;
    traits.backwardBusLanes = lanes.backwardBus;
    if (traits.isForBuses())
    {
        traits.forwardBusLanes = outermostLanes(lanes.forward, lanes.forward);
        traits.backwardBusLanes = outermostLanes(lanes.backward, lanes.backward);
    }
    std::tie(traits.rightCycles, traits.leftCycles) = cycleWaysOf(tags, direction);
    traits.forwardArrows = turnArrowsOf(tags, direction, true, lanes.forward);
    traits.backwardArrows = turnArrowsOf(tags, direction, false, lanes.backward);
    if (traits.isSingleTrack()) traits.laneWidthM = kSingleTrackM;
    if (!pavingM) return;
    const auto stripM = [](CycleWay way) { return way == CycleWay::lane ? kCycleLaneM : 0.0; };
    const double carsM = *pavingM - stripM(traits.leftCycles) - stripM(traits.rightCycles);
    const double eachM = carsM / (lanes.forward + lanes.backward + lanes.shared);
    if (eachM >= kLeastLaneM && eachM <= kMostLaneM)
        traits.laneWidthM = eachM;
    else
        countTag(approximated, tags, valueOf(tags, "width").empty() ? "est_width" : "width");
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

} // namespace

StreetTraits StreetTraits::reversed() const
{
    StreetTraits other = *this;
    std::swap(other.forwardLanes, other.backwardLanes);
    std::swap(other.forwardBusLanes, other.backwardBusLanes);
    std::swap(other.forwardKmh, other.backwardKmh);
    std::swap(other.hasLeftSidewalk, other.hasRightSidewalk);
    std::swap(other.leftCycles, other.rightCycles);
    std::swap(other.forwardArrows, other.backwardArrows);
    return other;
}

bool StreetTraits::hasSameLanes(const StreetTraits& other) const
{
    return forwardLanes == other.forwardLanes && backwardLanes == other.backwardLanes &&
           sharedLanes == other.sharedLanes && forwardBusLanes == other.forwardBusLanes &&
           backwardBusLanes == other.backwardBusLanes && laneKmh() == other.laneKmh() &&
           laneWidthM == other.laneWidthM && shoulderM == other.shoulderM && leftCycles == other.leftCycles &&
           rightCycles == other.rightCycles && hasLeftSidewalk == other.hasLeftSidewalk &&
           hasRightSidewalk == other.hasRightSidewalk && hasCentreMark == other.hasCentreMark &&
           hasEdgeMarks == other.hasEdgeMarks;
}

bool isClosedStreet(const Tags& tags)
{
    return classOfWay(valueOf(tags, "highway")) && !isNoStreet(tags) && isClosed(tags);
}

std::optional<StreetTraits> traitsOf(const Tags& tags, TagCounts* approximated)
{
    const std::string_view kind = valueOf(tags, "highway");
    const bool isLink = isLinkKind(kind);
    const StreetClass* found = classOfWay(kind);
    if (!found || isNoStreet(tags) || isClosed(tags)) return std::nullopt;
    StreetTraits traits;
    traits.name = valueOf(tags, "name");
    if (traits.name.empty()) traits.name = valueOf(tags, "ref");
    traits.kind = isClosedToCars(tags) ? "busway" : kind;
    traits.roadType = found->roadType;
    traits.importance = found->importance;
    traits.laneWidthM = found->laneWidthM;
    traits.shoulderM = found->shoulderM;
    traits.steepest = found->steepest;
    setLanes(tags, kind, isLink ? 1 : found->lanes, traits, approximated);
    setSpeeds(tags, isLink ? 0.6 * found->speedKmh : found->speedKmh, traits);
    setSidewalks(tags, traits);
    const std::string_view marks = valueOf(tags, "lane_markings");
    const bool isMarked = marks.empty() ? !isUnpaved(valueOf(tags, "surface")) : marks != "no";
    traits.hasCentreMark = isMarked && (found->hasCentreMark || marks == "yes") && traits.forwardLanes > 0 &&
                           traits.backwardLanes > 0;
    traits.hasEdgeMarks = isMarked && found->hasEdgeMarks;
    const WayLevel level = levelOf(tags);
    traits.place = level.place;
    traits.layer = level.layer;
    return traits;
}

} // namespace worldmaking
