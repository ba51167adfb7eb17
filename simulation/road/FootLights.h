// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "simulation/road/LightApproaches.h"

namespace simulation
{

/// A traffic light for people on foot, and the road that they cross. Units: metres.
struct FootLight
{
    std::string light;
    int place = -1; ///< of the approaches whose programme it belongs to
    int road = -1;
    double wideM = 0.0; ///< the lanes that they cross
};

/// Returns the dynamic lights for people on foot (1000002 of OpenDRIVE) that stand at a road, by places, then
/// roads. A light belongs to the lights for vehicles of its controller; where it has none, or a controller of
/// its own, to those on its road between junctions within 40 m, else to the nearer junction with lights at an
/// end of its road, within 80 m. Those that belong nowhere, or stand within a junction, are left out.
/// Source: ASAM OpenDRIVE 1.8, 14 (signals).
std::vector<FootLight> footLights(const RoadScene& roads, const std::vector<LightApproach>& approaches);

/// Whether people may cross a road while those of an approach have green: they do not come over that road,
/// and nobody of them drives straight into it. Who turns lets people pass.
bool goesWith(const FootLight& people, const LightApproach& approach, JunctionTable& table);

} // namespace simulation
