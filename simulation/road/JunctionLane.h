// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <compare>

namespace simulation
{

/// A lane of a road, through a junction or not, in one direction.
struct JunctionLane
{
    int road = -1; ///< an index into RoadNetwork::roads
    int lane = 0;  ///< where it is entered
    bool isForward = true;

    auto operator<=>(const JunctionLane&) const = default;
};

/// Where two vehicles on two lanes have no room beside each other. Units: metres along
/// each lane, of the rear axle, from where the lane is entered.
struct LaneConflict
{
    double ownFromM = 0.0, ownToM = 0.0, otherFromM = 0.0, otherToM = 0.0;
};

} // namespace simulation
