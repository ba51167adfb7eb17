// SPDX-License-Identifier: Apache-2.0
#include "RoadCandidate.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

namespace
{

constexpr double kPavingM = 1e6; ///< farther off than any lane

/// Returns how far a t beside the lanes is from them in the plan view; 0 on them.
double besideM(const Road& road, const RoadFrame& frame, double s, double t, double lateral)
{
    const RoadExtent extent = extentAt(road, s);
    const double edge = std::clamp(t, extent.rightT, extent.leftT);
    if (edge == t || !road.hasTilt()) return std::fabs(t - edge);
    return std::fabs(lateral - frame.lateralOf(edge, surfaceHeight(road, s, edge)));
}

/// Whether a place lies on the paving of a junction beside its lanes.
bool isOnPaving(const Road& road, double s, double t)
{
    if (road.junction < 0) return false;
    const auto lane = laneAt(road, s, t);
    return lane && lane->lane->type == LaneType::special;
}

} // namespace

RoadCandidate candidateOn(const RoadNetwork& network, const RoadPiece& piece, glm::dvec2 point, double height)
{
    const Road& road = network.roads[piece.road];
    const PlanElement& element = road.referenceLine.elements()[piece.element];
    const auto [ds, foot] = element.footOf(point, piece.guessAt(point), piece.from, piece.to);
    const double s = element.s + ds;
    const RoadFrame frame = frameAt(road, s, foot);
    const glm::dvec2 away = point - foot.position;
    const double lateral = glm::dot(away, frame.left());
    const double along = glm::dot(away, frame.tangent); // not 0 beyond the ends of the road
    RoadCandidate candidate;
    candidate.lateral = std::fabs(lateral);
    RoadPosition& position = candidate.match.position;
    position.road = static_cast<int>(piece.road);
    position.s = s;
    position.t = surfaceT(road, frame, s, lateral);
    position.h = surfaceHeight(road, s, position.t);
    const double beside = besideM(road, frame, s, position.t, lateral);
    // Who is on a lane of a junction is not on the paving below it.
    if (beside == 0.0 && isOnPaving(road, s, position.t)) candidate.lateral += kPavingM;
    double above = 0.0;
    if (!std::isnan(height))
    {
        above = height - frame.pointAt(position.t, position.h).z;
        const glm::dvec2 across =
            frame.across(glm::dvec3(glm::dvec2(frame.origin) + lateral * frame.left(), height));
        position.t = across.x;
        position.h = across.y;
    }
    candidate.match.distance = std::sqrt(beside * beside + along * along + above * above);
    return candidate;
}

} // namespace osgRoads::core
