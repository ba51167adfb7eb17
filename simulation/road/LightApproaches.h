// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/road/JunctionTable.h"

namespace simulation
{

/// A lane that those who have green drive on. Units: metres.
struct LightLane
{
    JunctionLane lane;
    double startM = 0.0; ///< from the begin of the first junction to that of the lane
};

/// Those who come to a junction over one road, and the traffic lights that hold for them. Units: metres,
/// radians, m/s.
struct LightApproach
{
    int place = -1;    ///< those of one place have one programme
    int junction = -1; ///< index; -1: the lights stand between junctions
    int road = -1;     ///< that leads to the junction, or on which the lights stand
    bool isForward = true;
    double headingRad = 0.0; ///< of those who come, where the road ends
    double limitMps = 0.0;
    double lineM = 0.0; ///< from the line of the lights to the junction
    std::vector<std::string> lights;
    double atM = 0.0;             ///< of lights between junctions, along the road
    std::vector<LightLane> lanes; ///< through the junction, and those of its place behind it
};

/// Returns what the dynamic traffic lights of a network hold for, by places, junctions, then roads; at the
/// end those lights that no junction follows within 80 m, by roads. Junctions that name one controller of the
/// network are one place. Lights of a controller that no junction names, which stand on one road for both
/// directions, are between junctions at any distance. A light that stands in a junction holds for the
/// road that leads to its connecting road; one whose orientation is none for both directions.
std::vector<LightApproach> lightApproaches(const RoadScene& roads);

/// Whether a network has dynamic traffic lights.
bool hasTrafficLights(const osgRoads::core::RoadNetwork& network);

} // namespace simulation
