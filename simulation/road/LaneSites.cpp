// SPDX-License-Identifier: Apache-2.0
#include "simulation/road/LaneSites.h"

#include <algorithm>

#include <osgRoads/core/query/LaneSpan.h>

namespace simulation
{
namespace
{

constexpr double kSpacingM = 5.0;
constexpr double kMostStations = 10000.0;
constexpr double kLeastWidthM = 2.0;

/// Adds the lanes of a road at one s.
void addAt(const RoadScene& roads, const osgRoads::core::Road& road, double s, std::vector<LaneSite>& sites)
{
    const osgRoads::core::LaneSection* const section = osgRoads::core::sectionAt(road, s);
    if (!section) return;
    for (const int sign : {-1, 1})
        osgRoads::core::forLanesOutwards(
            road, *section, sign, s,
            [&](const osgRoads::core::LaneSpan& span)
            {
                if (!osgRoads::core::isForCars(span.lane->type) || span.width() < kLeastWidthM) return true;
                if (const auto place = roads.onLane(road.id, span.lane->id, s, 0.0))
                {
                    const RoadPose pose = roads.poseAt(*place);
                    sites.push_back({*place, pose.position, pose.headingRad});
                }
                return true;
            });
}

} // namespace

double laneSiteSpacingM(const RoadScene& roads)
{
    return std::max(kSpacingM, roads.network().usableLengthM() / kMostStations);
}

std::vector<LaneSite> laneSites(const RoadScene& roads)
{
    std::vector<LaneSite> sites;
    const double spacing = laneSiteSpacingM(roads);
    for (const osgRoads::core::Road& road : roads.network().roads)
        if (road.isUsable && road.junctionId.empty())
            for (double s = 0.5 * std::min(spacing, road.length); s < road.length; s += spacing)
                addAt(roads, road, s, sites);
    return sites;
}

} // namespace simulation
