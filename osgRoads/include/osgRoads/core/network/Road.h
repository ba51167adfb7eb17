// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgRoads/core/geometry/ReferenceLine.h>
#include <osgRoads/core/network/Junction.h>
#include <osgRoads/core/network/Lane.h>
#include <osgRoads/core/network/RoadObject.h>
#include <osgRoads/core/network/Signal.h>

namespace osgRoads::core
{

/// What a road begins or ends at.
struct RoadLink
{
    bool isJunction = false;
    std::string elementId;
    int index = -1; ///< into RoadNetwork::roads or ::junctions; -1: there is none of that id
    ContactPoint contactPoint = ContactPoint::start; ///< of a road
    std::optional<double> elementS;                  ///< where on that road, next to a virtual junction
    int line = 0;
};

/// A slope across the road, outwards from the reference line: OpenDRIVE 1.4, 5.3.6.2. Positive angles fall
/// outwards.
struct Crossfall
{
    CubicProfile leftRad, rightRad;
};

/// The height of a cross-section above the road plane at one s, in pieces over t; linear between two of them.
/// Source: ASAM OpenDRIVE 1.8, 10.5.3 (road shape).
struct ShapeSection
{
    double s = 0.0;
    CubicProfile heights; ///< over t
};

struct RoadKind
{
    double s = 0.0;
    std::string type, country; ///< motorway, rural, town …
    std::optional<double> metresPerSecond;
};

/// A road as plain values. Its geometry is asked for by the functions of query/.
/// Units: metres, radians. Frames: s along the reference line in the plan view, t to the left, h up.
/// Source: ASAM OpenDRIVE 1.4 to 1.8 (sections of 1.8: 9 geometry, 10 roads, 11 lanes, 13 objects, 14
/// signals).
struct Road
{
    std::string id, name;
    std::string junctionId; ///< empty: none
    int junction = -1;      ///< index into RoadNetwork::junctions
    double length = 0.0;
    bool isLeftHandTraffic = false;
    ReferenceLine referenceLine;
    CubicProfile elevation;
    CubicProfile superelevationRad; ///< positive: the right side is lower
    Crossfall crossfall;
    std::vector<ShapeSection> shapes;
    CubicProfile laneOffset;
    std::vector<LaneSection> sections;
    std::optional<RoadLink> predecessor, successor;
    std::vector<RoadKind> kinds;
    std::vector<RoadObject> objects;
    std::vector<RoadStructure> structures;
    std::vector<Signal> signals;
    std::vector<SignalReference> signalReferences;
    int line = 0;

    /// False for a road whose geometry cannot be used (none, or longer than kLongestRoadM): it keeps its
    /// links, and no query answers with it.
    bool isUsable = false;

    bool hasTilt() const { return !superelevationRad.isEmpty(); }
};

/// Longer roads are reported and not used: an error of the program that wrote them.
inline constexpr double kLongestRoadM = 1e6;

} // namespace osgRoads::core
