// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <glm/vec3.hpp>

#include <osgRoads/core/network/RoadNetwork.h>

namespace osgRoads::core
{

/// A position on a road, in metres: s along the reference line in the plan view, t to the left, h above the
/// road plane (which is the surface but for shape, crossfall and lane heights).
struct RoadPosition
{
    int road = -1; ///< index into RoadNetwork::roads
    double s = 0.0, t = 0.0, h = 0.0;
};

/// Where and how something stands, in the inertial frame: radians, heading from x towards y, pitch positive
/// with the nose up, roll positive with the left side up.
struct WorldPose
{
    glm::dvec3 position{0.0, 0.0, 0.0};
    double headingRad = 0.0, pitchRad = 0.0, rollRad = 0.0;
    glm::dvec3 normal{0.0, 0.0, 1.0}; ///< of the road surface
};

/// Returns the inertial position of (s, t, h), without asking for the attitude.
glm::dvec3 worldPosition(const RoadNetwork& network, const RoadPosition& position);

/// Returns the pose of something that stands at a road position on the surface's slope and looks `headingRad`
/// to the left of the road.
WorldPose worldPose(const RoadNetwork& network, const RoadPosition& position, double headingRad = 0.0);

/// Returns the middle of a lane on the surface. Nothing: the section has no such lane.
std::optional<RoadPosition> laneCentre(const RoadNetwork& network, int road, int laneId, double s);

} // namespace osgRoads::core
