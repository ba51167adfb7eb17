// SPDX-License-Identifier: Apache-2.0
// Source: ASAM OpenDRIVE 1.8, 8 (coordinate systems).
#include <cmath>

#include <glm/geometric.hpp>

#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadPosition.h>
#include <osgRoads/core/query/RoadSurface.h>

namespace osgRoads::core
{

glm::dvec3 worldPosition(const RoadNetwork& network, const RoadPosition& position)
{
    const Road& road = network.roads[static_cast<std::size_t>(position.road)];
    return frameAt(road, position.s).pointAt(position.t, position.h);
}

WorldPose worldPose(const RoadNetwork& network, const RoadPosition& position, double headingRad)
{
    const Road& road = network.roads[static_cast<std::size_t>(position.road)];
    const RoadFrame frame = frameAt(road, position.s);
    WorldPose pose;
    pose.position = frame.pointAt(position.t, position.h);
    pose.normal = surfaceNormal(road, position.s, position.t);
    pose.headingRad = frame.headingRad + headingRad;
    // The tangent plane has the slope -n·forward/n.z along the heading; the left axis of the body is
    // horizontal before it rolls, so the roll alone takes the normal off it.
    const glm::dvec2 forward(std::cos(pose.headingRad), std::sin(pose.headingRad));
    const glm::dvec2 left(-forward.y, forward.x);
    const double along = -(pose.normal.x * forward.x + pose.normal.y * forward.y) / pose.normal.z;
    pose.pitchRad = std::atan(along);
    pose.rollRad = -std::asin(pose.normal.x * left.x + pose.normal.y * left.y);
    return pose;
}

std::optional<RoadPosition> laneCentre(const RoadNetwork& network, int road, int laneId, double s)
{
    const Road& on = network.roads[static_cast<std::size_t>(road)];
    const std::optional<LaneSpan> span = laneSpan(on, laneId, s);
    if (!span) return std::nullopt;
    const double t = span->centreT();
    return RoadPosition{road, s, t, surfaceHeight(on, s, t)};
}

} // namespace osgRoads::core
