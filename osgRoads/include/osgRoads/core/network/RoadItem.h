// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace osgRoads::core
{

/// The lanes that an object or a signal holds for.
struct LaneValidity
{
    int fromLane = 0, toLane = 0;
};

/// What objects and signals share: both are placed beside or on a road in the same way. Angles in radians,
/// sizes in metres.
/// Source: ASAM OpenDRIVE 1.8, 13.1 (object), 14.1 (signal).
struct RoadItem
{
    std::string id, name, type, subtype;
    double s = 0.0, t = 0.0, zOffset = 0.0;
    char orientation = '0'; ///< '+', '-', or '0' for both directions
    double headingRad = 0.0, pitchRad = 0.0,
           rollRad = 0.0; ///< heading: of an object to the road, of a signal to its orientation
    double width = 0.0, height = 0.0;
    bool isDynamic = false;
    std::vector<LaneValidity> validities;
    int line = 0;
};

} // namespace osgRoads::core
