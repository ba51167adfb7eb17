// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace simulation
{

/// Where an entity is on a road: the lane that it drives on, and how far from the lane's middle.
/// Frame: s along the reference line, t and offset to its left. Units: metres, radians.
struct RoadPlace
{
    int road = -1; ///< index into RoadNetwork::roads
    double s = 0.0;
    double t = 0.0;
    int lane = 0;
    double laneOffsetM = 0.0;        ///< from the middle of the lane
    double relativeHeadingRad = 0.0; ///< of the entity, from the heading of the reference line
    double curvature = 0.0;          ///< of the reference line, 1/m, positive to the left
};

} // namespace simulation
