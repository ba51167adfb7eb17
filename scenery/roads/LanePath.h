// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <osgRoads/core/place/PlacedNetwork.h>
#include <osgRoads/core/query/LaneRoute.h>

namespace scenery
{

/// A place on the middle of a lane, and the speed that is allowed there.
struct LanePathPoint
{
    glm::dvec3 place{0.0};
    double limitMps = 0.0;
};

/// Returns the middle of a route's lanes, kLanePathStepM apart, in the direction of travel; in lanes narrower
/// than 2.5 m it is 1.25 m from the outer border. Where the lanes do not meet (a change of lane, a joint that
/// is not exact) the path goes over from one to the other within kBlendWayM. Speeds are those of the roads
/// (`type`), in towns where nothing is told.
/// Frame: the scene's. Units: metres, m/s.
std::vector<LanePathPoint> lanePath(const osgRoads::core::PlacedNetwork& roads,
                                    const osgRoads::core::LaneRoute& route);

/// Returns the mean of the speeds that are allowed on the roads, by their lengths.
double defaultSpeedMps(const osgRoads::core::RoadNetwork& network);

inline constexpr double kLanePathStepM = 1.0, kBlendWayM = 40.0;

} // namespace scenery
