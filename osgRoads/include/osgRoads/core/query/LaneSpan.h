// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>

#include <osgRoads/core/network/Road.h>

namespace osgRoads::core
{

/// A lane at one s: the t of its inner and outer border, metres.
struct LaneSpan
{
    const Lane* lane = nullptr;
    double innerT = 0.0, outerT = 0.0;

    double centreT() const { return 0.5 * (innerT + outerT); }
    double width() const { return outerT > innerT ? outerT - innerT : innerT - outerT; }
};

/// The lanes of a road at one s reach from rightT to leftT; 0 on a side without lanes.
struct RoadExtent
{
    double rightT = 0.0, leftT = 0.0;
};

/// Returns the lane section at s, or nullptr when the road has none.
inline const LaneSection* sectionAt(const Road& road, double s)
{
    if (road.sections.empty()) return nullptr;
    const int index = lastStartingBy(road.sections, s);
    return &road.sections[index < 0 ? 0 : static_cast<std::size_t>(index)];
}

/// Calls `use(LaneSpan)` for the lanes of one side from the centre outwards, until it returns false. A
/// negative width counts as 0. A border on the wrong side of the one inside it does so, too.
/// Source: ASAM OpenDRIVE 1.8, 11.4 (lane offset), 11.6 (lane width), 11.7 (lane border).
template<class Use>
void forLanesOutwards(const Road& road, const LaneSection& section, int sign, double s, const Use& use)
{
    const double offset = road.laneOffset.value(s), ds = s - section.s;
    double innerT = offset;
    for (const Lane& lane : sign > 0 ? section.left : section.right)
    {
        const double value = lane.width.value(ds);
        const double width = lane.isByBorder ? sign * (offset + value - innerT) : value;
        const double outerT = innerT + sign * std::max(width, 0.0);
        if (!use(LaneSpan{&lane, innerT, outerT})) return;
        innerT = outerT;
    }
}

/// Returns the extent of the lanes at s.
RoadExtent extentAt(const Road& road, double s);

/// Returns the lane at (s, t), or nothing beside the road. On a border the inner lane counts.
std::optional<LaneSpan> laneAt(const Road& road, double s, double t);

/// Returns the borders of a lane at s, or nothing when the section has no such lane.
std::optional<LaneSpan> laneSpan(const Road& road, int laneId, double s);

/// Tells whether traffic on the lane runs towards greater s.
bool runsForward(const Road& road, const Lane& lane);

} // namespace osgRoads::core
