// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/LeadVehicle.h"

#include <algorithm>
#include <cmath>

#include "simulation/player/EntityDistance.h"
#include "simulation/road/RoadWalk.h"

namespace simulation
{
namespace
{

MeasuredBody bodyOf(ActionScene& scene, int entity)
{
    return {&scene.motion(entity).state(), scene.scenario().entities[static_cast<std::size_t>(entity)].box()};
}

/// t to the left of the direction in which `place` looks.
double leftOf(const RoadPlace& place)
{
    return looksForward(place) ? place.t : -place.t;
}

/// By the lanes that are under them: one that changes its lane still has the one that it leaves.
bool isOnLaneOf(RoadPlace own, RoadPlace other, const RoadScene& roads, double lateralM)
{
    constexpr double kHalfLaneM = 1.75; // roads that follow one another may count their lanes otherwise
    const double beside = std::fabs(leftOf(other) - leftOf(own));
    if (beside >= lateralM) return false;
    if (own.road != other.road) return beside < kHalfLaneM;
    roads.takeNearestLane(own);
    roads.takeNearestLane(other);
    return own.lane == other.lane;
}

/// The free distance along the road; nothing: not ahead on the lane.
std::optional<double> gapOnLane(const MeasuredBody& own, const MeasuredBody& other, const RoadScene& roads,
                                double lookAheadM, double lateralM)
{
    if (!own.state->place || !other.state->place) return std::nullopt;
    const auto ahead = distanceAlong(roads, *own.state->place, *other.state->place, lookAheadM);
    if (!ahead || *ahead > lookAheadM || !isOnLaneOf(*own.state->place, *other.state->place, roads, lateralM))
        return std::nullopt;
    const double turn = glm::radians(other.state->headingDeg - own.state->headingDeg);
    const double otherMiddle = std::cos(turn) > 0.0 ? other.box.centre.x : -other.box.centre.x;
    const double gap = *ahead + otherMiddle - own.box.centre.x - 0.5 * (own.box.lengthM + other.box.lengthM);
    return gap > 0.0 ? std::optional(gap) : std::nullopt;
}

/// The free distance ahead to one that comes in from beside.
std::optional<double> gapToCutIn(const MeasuredBody& own, const MeasuredBody& other)
{
    const DistanceMeasure ahead{DistanceFrame::entity, DistanceKind::longitudinal, true};
    const DistanceMeasure beside{DistanceFrame::entity, DistanceKind::lateral, true};
    const double x = *distanceBetween(own, other, ahead, nullptr);
    const double y = *distanceBetween(own, other, beside, nullptr);
    const double closing = std::max(0.0, own.state->speedMps - other.state->speedMps);
    const bool isNear = x > 0.0 && x < 1.0 + other.box.lengthM + 0.5 * closing && y < 0.2 && y > -0.5;
    return isNear ? std::optional(x) : std::nullopt;
}

/// Spares the search along the roads: who is farther away in a straight line is so along them. A reference
/// line inside a bend may be half as long as the lane.
bool isTooFar(const MeasuredBody& own, const MeasuredBody& other, double lookAheadM)
{
    const double reach = 2.0 * lookAheadM + own.box.lengthM + other.box.lengthM;
    const glm::dvec2 apart(other.state->position - own.state->position);
    return glm::dot(apart, apart) > reach * reach;
}

} // namespace

std::optional<LeadVehicle> leadVehicleOf(ActionScene& scene, int actor, double lookAheadM, double lateralM)
{
    std::optional<LeadVehicle> lead;
    const MeasuredBody own = bodyOf(scene, actor);
    for (int i = 0; i < static_cast<int>(scene.scenario().entities.size()); ++i)
    {
        if (i == actor || !scene.isPresent(i)) continue;
        const MeasuredBody other = bodyOf(scene, i);
        if (isTooFar(own, other, lookAheadM)) continue;
        std::optional<double> gap =
            scene.roads() ? gapOnLane(own, other, *scene.roads(), lookAheadM, lateralM) : std::nullopt;
        if (gap && lead && *gap >= lead->gapM) gap.reset();
        if (!gap) gap = gapToCutIn(own, other);
        if (gap && (!lead || *gap < lead->gapM)) lead = LeadVehicle{i, *gap};
    }
    return lead;
}

} // namespace simulation
