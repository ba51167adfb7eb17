// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 11 (lanes).
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>

namespace osgRoads::core
{

RoadExtent extentAt(const Road& road, double s)
{
    const LaneSection* section = sectionAt(road, s);
    if (!section) return {};
    const double offset = road.laneOffset.value(s);
    RoadExtent extent{offset, offset};
    forLanesOutwards(road, *section, 1, s,
                     [&](const LaneSpan& span)
                     {
                         extent.leftT = span.outerT;
                         return true;
                     });
    forLanesOutwards(road, *section, -1, s,
                     [&](const LaneSpan& span)
                     {
                         extent.rightT = span.outerT;
                         return true;
                     });
    return extent;
}

std::optional<LaneSpan> laneAt(const Road& road, double s, double t)
{
    const LaneSection* section = sectionAt(road, s);
    if (!section) return std::nullopt;
    const int sign = t >= road.laneOffset.value(s) ? 1 : -1;
    std::optional<LaneSpan> found;
    const auto search = [&](const LaneSpan& span)
    {
        const double beyond = span.lane->id > 0 ? t - span.outerT : span.outerT - t;
        if (beyond <= 0.0 && span.width() > 0.0) found = span;
        return !found;
    };
    forLanesOutwards(road, *section, sign, s, search);
    if (!found && t == road.laneOffset.value(s)) forLanesOutwards(road, *section, -sign, s, search);
    return found;
}

std::optional<LaneSpan> laneSpan(const Road& road, int laneId, double s)
{
    const LaneSection* section = sectionAt(road, s);
    if (!section || !section->lane(laneId)) return std::nullopt;
    if (laneId == 0)
    {
        const double offset = road.laneOffset.value(s);
        return LaneSpan{&section->centre, offset, offset};
    }
    std::optional<LaneSpan> found;
    forLanesOutwards(road, *section, laneId > 0 ? 1 : -1, s,
                     [&](const LaneSpan& span)
                     {
                         if (span.lane->id == laneId) found = span;
                         return !found;
                     });
    return found;
}

bool runsForward(const Road& road, const Lane& lane)
{
    return ((lane.id < 0) != road.isLeftHandTraffic) != (lane.direction == LaneDirection::reversed);
}

} // namespace osgRoads::core
