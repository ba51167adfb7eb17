// SPDX-License-Identifier: Apache-2.0
#include "JunctionCover.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

bool hasPaving(const LaneSection& section)
{
    const auto isPaving = [](const Lane& lane) { return lane.type == LaneType::special; };
    return std::any_of(section.left.begin(), section.left.end(), isPaving) ||
           std::any_of(section.right.begin(), section.right.end(), isPaving);
}

/// Whether a road of the same junction has paving of its own. Those of a junction follow each other.
bool isAmongEdges(const RoadNetwork& network, int road)
{
    const int count = static_cast<int>(network.roads.size());
    const auto at = [&](int index) -> const Road& { return network.roads[static_cast<std::size_t>(index)]; };
    for (const int step : {1, -1})
        for (int i = road + step; i >= 0 && i < count && at(i).junction == at(road).junction; i += step)
            if (std::any_of(at(i).sections.begin(), at(i).sections.end(), hasPaving)) return true;
    return false;
}

bool bearsEdgeAt(const Road& road, double s)
{
    const LaneSection* section = road.junction >= 0 ? sectionAt(road, s) : nullptr;
    return section && hasPaving(*section);
}

/// Returns how far the lanes for cars reach.
RoadExtent carriagewayAt(const Road& road, double s)
{
    const LaneSection* section = sectionAt(road, s);
    if (!section) return {};
    RoadExtent extent{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
    for (const int sign : {1, -1})
        forLanesOutwards(road, *section, sign, s,
                         [&](const LaneSpan& span)
                         {
                             if (!isForCars(span.lane->type)) return true;
                             extent.rightT = std::min({extent.rightT, span.innerT, span.outerT});
                             extent.leftT = std::max({extent.leftT, span.innerT, span.outerT});
                             return true;
                         });
    return extent;
}

} // namespace

JunctionCover::JunctionCover(const PlacedNetwork& network, int road)
    : _network(network),
      _road(road),
      _isConnecting(network.road(road).junction >= 0),
      _canCover(_isConnecting || meetsJunction(network.road(road).predecessor) ||
                meetsJunction(network.road(road).successor)),
      _bearsEdge(_isConnecting && std::any_of(network.road(road).sections.begin(),
                                              network.road(road).sections.end(), hasPaving))
{
    if (!_isConnecting) return;
    const Road& own = network.road(road);
    _isRightWithin = !_bearsEdge && isAmongEdges(network.network(), road);
    _isLeftWithin = _bearsEdge ? !own.sections.front().left.empty() &&
                                     own.sections.front().left.back().type == LaneType::special
                               : _isRightWithin;
}

bool JunctionCover::hasOwnPaving(double s) const
{
    const LaneSection* section = sectionAt(_network.road(_road), s);
    return section && hasPaving(*section);
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
        // Beside an edge of paving the border of a carriageway counts, though other lanes lie beyond it.
        const bool isAtEdge = by == By::carriageway && (_bearsEdge || bearsEdgeAt(other, match.position.s));
        const RoadExtent extent =
            isAtEdge ? carriagewayAt(other, match.position.s) : extentAt(other, match.position.s);
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
