// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <osgRoads/core/place/TunnelTube.h>
#include <osgRoads/core/query/LaneSpan.h>

namespace osgRoads::core
{

namespace
{

constexpr double kEndM = 0.01;
constexpr double kNoPortalM = 1e9;

} // namespace

RoadSides pavedSides(const Road& road, double s)
{
    const double middle = road.laneOffset.value(s);
    RoadSides sides{middle, middle};
    const LaneSection* section = sectionAt(road, s);
    if (!section) return sides;
    for (const int sign : {1, -1})
        forLanesOutwards(road, *section, sign, s,
                         [&](const LaneSpan& span)
                         {
                             if (span.lane->type != LaneType::none)
                                 (sign > 0 ? sides.left : sides.right) = span.outerT;
                             return true;
                         });
    return sides;
}

RoadSides tunnelSides(const Road& road, double s, const TunnelTube& tube)
{
    const RoadSides paved = pavedSides(road, s);
    return {paved.left + tube.besideM, paved.right - tube.besideM};
}

double depthInTunnel(const Road& road, const RoadStructure& tunnel, double s)
{
    const double end = tunnel.s + tunnel.length;
    const double fromStart = tunnel.s > kEndM ? s - tunnel.s : kNoPortalM;
    const double toEnd = end < road.length - kEndM ? end - s : kNoPortalM;
    return std::min(fromStart, toEnd);
}

} // namespace osgRoads::core
