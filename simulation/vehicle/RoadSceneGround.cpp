// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/RoadSceneGround.h"

#include <cmath>

#include <osgRoads/core/query/LaneSpan.h>

namespace simulation
{

void RoadSceneGround::below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const
{
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        answers[i] = {};
        std::optional<RoadPlace> place = _roads->nearest(points[i], 0.0);
        if (!place) continue;
        place->heightM = 0.0;
        const RoadPose pose = _roads->poseAt(*place);
        const double pitch = pose.pitchRad, roll = pose.rollRad;
        // Up, of a body with these angles: pitch nose down, roll right side down.
        const glm::dvec3 up(std::sin(pitch) * std::cos(roll), -std::sin(roll),
                            std::cos(pitch) * std::cos(roll));
        const double c = std::cos(pose.headingRad), s = std::sin(pose.headingRad);
        const glm::dvec3 normal = glm::normalize(glm::dvec3(c * up.x - s * up.y, s * up.x + c * up.y, up.z));
        // The plane of the road there, at the point.
        const glm::dvec3 apart = points[i] - pose.position;
        const double height = pose.position.z - (normal.x * apart.x + normal.y * apart.y) / normal.z;
        const bool isPaved = osgRoads::core::laneAt(_roads->roadAt(*place), place->s, place->t).has_value();
        answers[i] = {height, normal, isPaved ? GroundKind::asphalt : GroundKind::grass, true};
    }
}

} // namespace simulation
