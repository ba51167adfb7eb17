// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/streets/LaneLayout.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <foundation/Units.h>

namespace worldmaking
{

namespace
{

using osgRoads::core::Cubic;
using osgRoads::core::CubicProfile;
using osgRoads::core::Lane;
using osgRoads::core::LaneSection;
using osgRoads::core::LaneType;
using osgRoads::core::MarkType;
using osgRoads::core::RoadMark;
using Strip = LaneLayout::Strip;

constexpr double kSidewalkM = 1.5, kCycleTrackM = 2.0, kMarkM = 0.12;
constexpr double kTaperM = 30.0; ///< over which lanes change their width

/// One side of a street.
struct Side
{
    int lanes, sharedLanes;
    LaneSet busLanes;
    bool hasSidewalk;
    double speedKmh;
    CycleWay cycles;
};

std::vector<Strip> sideOf(const StreetTraits& traits, const Side& side)
{
    std::vector<Strip> strips;
    const MarkType edge = traits.hasEdgeMarks ? MarkType::solid : MarkType::none;
    for (int i = 0; i < side.sharedLanes; ++i)
    {
        const bool isEdge = side.lanes == 0 && i + 1 == side.sharedLanes;
        const MarkType between =
            traits.hasCentreMark || i + 1 < side.sharedLanes ? MarkType::broken : MarkType::none;
        strips.push_back({LaneType::driving, i, traits.laneWidthM, isEdge ? edge : between, true,
                          traits.isForBuses(), 0.0});
    }
    const auto isForBuses = [&](int lane)
    { return (side.busLanes >> static_cast<unsigned>(lane) & 1U) != 0; };
    for (int i = 0; i < side.lanes; ++i)
    {
        const bool isLast = i + 1 == side.lanes;
        const MarkType inner = isForBuses(i) == isForBuses(i + 1) ? MarkType::broken : MarkType::solid;
        strips.push_back({LaneType::driving, i, traits.laneWidthM, isLast ? edge : inner, false,
                          isForBuses(i), side.speedKmh});
    }
    if (side.cycles == CycleWay::lane)
    {
        if (!strips.empty()) strips.back().outerMark = MarkType::solid;
        strips.push_back({LaneType::biking, 0, kCycleLaneM, edge});
    }
    if (traits.shoulderM > 0.0) strips.push_back({LaneType::shoulder, 0, traits.shoulderM, MarkType::none});
    if (side.cycles == CycleWay::track) // behind the kerb
        strips.push_back({LaneType::biking, 1, kCycleTrackM, MarkType::solid});
    if (side.hasSidewalk) strips.push_back({LaneType::sidewalk, 0, kSidewalkM, MarkType::none});
    return strips;
}

/// Whether a strip lies between the kerbs.
bool isOfPaving(const Strip& strip)
{
    return strip.type == LaneType::driving || (strip.type == LaneType::biking && strip.order == 0);
}

double widthOf(const std::vector<Strip>& strips, bool carriagewayOnly)
{
    double width = 0.0;
    for (const Strip& strip : strips)
        if (!carriagewayOnly || isOfPaving(strip)) width += strip.widthM;
    return width;
}

/// A smooth step from one value to another.
Cubic taper(double s, double from, double to, double lengthM)
{
    const double rise = to - from;
    return {s, from, 0.0, 3.0 * rise / (lengthM * lengthM), -2.0 * rise / (lengthM * lengthM * lengthM)};
}

/// A lane with its widths at both ends of a section.
struct Grown
{
    Strip strip; ///< as it begins
    Strip last;  ///< as it ends
    double fromM = 0.0, toM = 0.0;
    bool isBefore = true, isAfter = true; ///< it goes on on that side
};

/// Whether one lane goes on as the other: a single track, which counts to the right side, as the innermost
/// lane of that side.
bool goesOn(const Strip& before, const Strip& after)
{
    const bool isDriven = before.type == LaneType::driving && after.type == LaneType::driving;
    return before.isSameLane(after) ||
           (isDriven && before.isShared != after.isShared && before.order == 0 && after.order == 0);
}

/// Whether a lane for both directions lies beside those of this one.
bool hasTurnLane(const std::vector<Strip>& side)
{
    const auto isDriven = [](const Strip& strip) { return strip.type == LaneType::driving; };
    return std::any_of(side.begin(), side.end(), [](const Strip& strip) { return strip.isShared; }) &&
           std::any_of(side.begin(), side.end(),
                       [&](const Strip& strip) { return isDriven(strip) && !strip.isShared; });
}

/// The lanes of two layouts side by side, from the centre outwards: by type, and within a type by order.
std::vector<Grown> grown(const std::vector<Strip>& before, const std::vector<Strip>& after)
{
    std::vector<Grown> lanes;
    const bool isSingle = !hasTurnLane(before) && !hasTurnLane(after);
    for (const Strip& strip : before)
        lanes.push_back({strip, strip, strip.widthM, 0.0, true, false});
    for (const Strip& strip : after)
    {
        const auto same = std::find_if(lanes.begin(), lanes.end(),
                                       [&](const Grown& lane) {
                                           return lane.isBefore && (isSingle ? goesOn(lane.strip, strip)
                                                                             : lane.strip.isSameLane(strip));
                                       });
        if (same == lanes.end())
            lanes.push_back({strip, strip, 0.0, strip.widthM, false, true});
        else
        {
            same->toM = strip.widthM, same->isAfter = true, same->strip.outerMark = strip.outerMark;
            same->last = strip;
        }
    }
    const auto rank = [](const Grown& lane)
    {
        return std::pair(lane.strip.type == LaneType::driving    ? (lane.strip.isShared ? 0 : 1)
                         : isOfPaving(lane.strip)                ? 2
                         : lane.strip.type == LaneType::shoulder ? 3
                         : lane.strip.type == LaneType::biking   ? 4
                                                                 : 5,
                         lane.strip.order);
    };
    std::stable_sort(lanes.begin(), lanes.end(),
                     [&](const Grown& a, const Grown& b) { return rank(a) < rank(b); });
    return lanes;
}

Lane laneOf(const Grown& grown, int id, double lengthM)
{
    Lane lane;
    lane.id = id;
    lane.type = grown.strip.type;
    lane.width = CubicProfile(
        {grown.fromM == grown.toM ? Cubic{0.0, grown.fromM} : taper(0.0, grown.fromM, grown.toM, lengthM)});
    RoadMark mark;
    mark.type = grown.strip.outerMark;
    mark.width = kMarkM;
    if (mark.type != MarkType::none) lane.marks.push_back(mark);
    if (grown.strip.isShared || grown.last.isShared) lane.direction = osgRoads::core::LaneDirection::both;
    if (grown.strip.isForBuses) lane.access.push_back({0.0, "allow", "bus"});
    if (grown.strip.speedKmh > 0.0)
        lane.speeds.push_back({0.0, grown.strip.speedKmh / foundation::kKmhPerMps});
    const bool isRaised =
        lane.type == LaneType::sidewalk || (lane.type == LaneType::biking && !isOfPaving(grown.strip));
    if (isRaised) lane.heights.push_back({0.0, kKerbM, kKerbM});
    return lane;
}

/// Links the lanes of two sections that follow each other on one side of the road.
void linkSides(std::vector<Lane>& before, const std::vector<Grown>& beforeGrown, std::vector<Lane>& after,
               const std::vector<Grown>& afterGrown)
{
    for (std::size_t i = 0; i < beforeGrown.size(); ++i)
        for (std::size_t j = 0; j < afterGrown.size(); ++j)
            if (beforeGrown[i].isAfter && afterGrown[j].isBefore &&
                beforeGrown[i].last.isSameLane(afterGrown[j].strip))
            {
                before[i].successors = {after[j].id};
                after[j].predecessors = {before[i].id};
            }
}

/// Builds the sections of a road one behind the other.
class SectionBuilder
{
public:
    void add(double startM, double lengthM, const LaneLayout& before, const LaneLayout& after)
    {
        Sides grownSides{grown(before.left, after.left), grown(before.right, after.right)};
        LaneSection section;
        section.s = startM;
        section.end = startM + lengthM;
        for (std::size_t i = 0; i < grownSides.left.size(); ++i)
            section.left.push_back(laneOf(grownSides.left[i], static_cast<int>(i) + 1, lengthM));
        for (std::size_t i = 0; i < grownSides.right.size(); ++i)
            section.right.push_back(laneOf(grownSides.right[i], -static_cast<int>(i) - 1, lengthM));
        RoadMark centre;
        centre.type = after.centreMark;
        centre.width = kMarkM;
        if (centre.type != MarkType::none) section.centre.marks.push_back(centre);
        if (!lanes.sections.empty())
        {
            linkSides(lanes.sections.back().left, _sides.left, section.left, grownSides.left);
            linkSides(lanes.sections.back().right, _sides.right, section.right, grownSides.right);
        }
        offsets.push_back(before.offsetM == after.offsetM
                              ? Cubic{startM, after.offsetM}
                              : taper(startM, before.offsetM, after.offsetM, lengthM));
        lanes.sections.push_back(std::move(section));
        _sides = std::move(grownSides);
    }

    RoadLanes lanes;
    std::vector<Cubic> offsets;

private:
    struct Sides
    {
        std::vector<Grown> left, right;
    };
    Sides _sides;
};

} // namespace

double LaneLayout::halfWidthM() const
{
    return std::max(widthOf(left, false) + offsetM, widthOf(right, false) - offsetM);
}

LaneLayout layoutOf(const StreetTraits& traits)
{
    LaneLayout layout;
    const auto [forwardKmh, backwardKmh] = traits.laneKmh();
    layout.left = sideOf(traits, {traits.backwardLanes, 0, traits.backwardBusLanes, traits.hasLeftSidewalk,
                                  backwardKmh, traits.leftCycles});
    layout.right = sideOf(traits, {traits.forwardLanes, traits.sharedLanes, traits.forwardBusLanes,
                                   traits.hasRightSidewalk, forwardKmh, traits.rightCycles});
    layout.centreMark = traits.hasCentreMark ? MarkType::broken : MarkType::none;
    if (traits.hasCentreMark && traits.forwardLanes + traits.backwardLanes > 3)
        layout.centreMark = MarkType::solidSolid;
    layout.offsetM = 0.5 * (widthOf(layout.right, true) - widthOf(layout.left, true));
    return layout;
}

RoadLanes lanesOf(const std::vector<LayoutPart>& parts, double lengthM)
{
    SectionBuilder builder;
    for (std::size_t i = 0; i < parts.size(); ++i)
    {
        const double startM = parts[i].startM, endM = i + 1 < parts.size() ? parts[i + 1].startM : lengthM;
        const double taperM = i == 0 ? 0.0 : std::min(kTaperM, 0.5 * (endM - startM));
        if (i > 0) builder.add(startM, taperM, parts[i - 1].layout, parts[i].layout);
        builder.add(startM + taperM, endM - startM - taperM, parts[i].layout, parts[i].layout);
    }
    builder.lanes.offset = CubicProfile(std::move(builder.offsets));
    return std::move(builder.lanes);
}

} // namespace worldmaking
