// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "simulation/road/RoadScene.h"

namespace simulation
{

/// A place in the middle of a lane, looking along its traffic.
struct LaneSite
{
    RoadPlace place;
    glm::dvec3 position{0.0};
    double headingRad = 0.0;
};

/// The metres from one place to the next along a road.
double laneSiteSpacingM(const RoadScene& roads);

/// Returns places on all lanes for cars, evenly along the roads, but for those within junctions: every 5 m,
/// or farther apart so that there are some 40 000 at most. In the order of the file.
std::vector<LaneSite> laneSites(const RoadScene& roads);

} // namespace simulation
