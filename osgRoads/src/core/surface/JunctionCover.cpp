// SPDX-License-Identifier: Apache-2.0
#include "JunctionCover.h"

#include <algorithm>
#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr double kJointM = 0.02;
constexpr double kWidestGapM = 5.0;
constexpr double kWithinM = 1e-3; ///< a border that two roads share belongs to both

bool meetsJunction(const std::optional<RoadLink>& link)
{
    return link && link->isJunction;
}

} // namespace

JunctionCover::JunctionCover(const PlacedNetwork& network, int road)
    : _network(network),
      _road(road),
      _isConnecting(network.road(road).junction >= 0),
      _canCover(_isConnecting || meetsJunction(network.road(road).predecessor) ||
                meetsJunction(network.road(road).successor))
{
}

bool JunctionCover::isNearOther(double s, double radiusM) const
{
    const glm::dvec2 place = _network.road(_road).referenceLine.at(s).position;
    return _network.locator().holdsOnOther(place, radiusM, _road, [](const RoadMatch&) { return true; });
}

bool JunctionCover::covers(double s, double t, By by) const
{
    const Road& own = _network.road(_road);
    const glm::dvec3 place = surfacePoint(own, s, t);
    // Where roads are joined, a verge on the joint lies on both of them but for rounding.
    const double reach = by == By::paving ? kJointM : 0.0;
    const auto isCover = [&](const RoadMatch& match)
    {
        const Road& other = _network.road(match.position.road);
        const auto lane = laneAt(other, match.position.s, match.position.t);
        if (!lane) return false;
        const LaneType type = lane->lane->type;
        if (by == By::carriageway ? !isForCars(type) : type == LaneType::none) return false;
        const RoadExtent extent = extentAt(other, match.position.s);
        const double inside = std::min(extent.leftT - match.position.t, match.position.t - extent.rightT);
        const double above = surfacePoint(other, match.position.s, match.position.t).z - place.z;
        return inside > kWithinM && std::fabs(above) < kSameLevelM;
    };
    return _network.locator().holdsOnOther(glm::dvec2(place), reach, _road, isCover);
}

bool JunctionCover::isGap(double s, double t, int side) const
{
    for (double away = 0.0; away <= kWidestGapM; away += 1.0)
        if (covers(s, t + side * away)) return true;
    return false;
}

} // namespace osgRoads::core
