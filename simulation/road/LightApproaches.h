// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/road/JunctionTable.h"

namespace simulation
{

/// Those who come to a junction over one road, and the traffic lights that hold for them. Units: metres,
/// radians, m/s.
struct LightApproach
{
    int junction = -1; ///< index; -1: the lights stand between junctions
    int road = -1;     ///< that leads to the junction, or on which the lights stand
    bool isForward = true;
    double headingRad = 0.0; ///< of those who come, where the road ends
    double limitMps = 0.0;
    double lineM = 0.0; ///< from the line of the lights to the junction
    std::vector<std::string> lights;
    std::vector<JunctionLane> lanes; ///< through the junction
};

/// Returns what the dynamic traffic lights of a network hold for, by junctions, then roads; at the end those
/// lights that no junction follows within 80 m, by roads. A light that stands in a junction holds for the
/// road that leads to its connecting road; one whose orientation is none for both directions.
std::vector<LightApproach> lightApproaches(const RoadScene& roads);

/// Whether a network has dynamic traffic lights.
bool hasTrafficLights(const osgRoads::core::RoadNetwork& network);

} // namespace simulation
