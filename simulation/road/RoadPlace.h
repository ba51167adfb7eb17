// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

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
    double heightM = 0.0;            ///< above the surface
    double curvature = 0.0;          ///< of the reference line, 1/m, positive to the left
};

/// Whether what stands at a place looks towards greater s.
inline bool looksForward(const RoadPlace& place)
{
    return std::cos(place.relativeHeadingRad) >= 0.0;
}

} // namespace simulation
