// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <osgRoads/core/network/RoadItem.h>
#include <osgRoads/core/network/RoadMark.h>

namespace osgRoads::core
{

/// A corner of an outline: on the road (s, t, dz) or in the frame of the object (u, v, z). Units: metres.
struct OutlineCorner
{
    bool isOnRoad = false;
    double s = 0.0, t = 0.0; ///< or u and v
    double z = 0.0;          ///< above the road, or above the origin of the object
    double height = 0.0;
    int id = -1;
};

struct ObjectOutline
{
    std::vector<OutlineCorner> corners;
    bool isClosed = true;
    bool isOuter = true;
    std::string fillType, laneType;
};

/// An object that stands many times along the road, or without a break (distance 0). Values change linearly
/// from start to end. Units: metres. A value that is not told is that of the object.
struct ObjectRepeat
{
    double s = 0.0, length = 0.0, distance = 0.0;
    double tStart = 0.0, tEnd = 0.0;
    double zOffsetStart = 0.0, zOffsetEnd = 0.0;
    std::optional<double> heightStart, heightEnd, widthStart, widthEnd, lengthStart, lengthEnd, radiusStart,
        radiusEnd;
};

/// A side of an object's length and width in its own frame (u ahead, v to the left).
enum class ObjectSide
{
    none,
    left,
    right,
    front,
    rear,
};

inline constexpr Keywords<ObjectSide, 4> kObjectSides = {{{"left", ObjectSide::left},
                                                          {"right", ObjectSide::right},
                                                          {"front", ObjectSide::front},
                                                          {"rear", ObjectSide::rear}}};

/// A line that is painted along a side of an object, or from corner to corner of its outlines. Units: metres.
/// Source: ASAM OpenDRIVE 1.8, 13.7 (object markings).
struct ObjectMarking
{
    ObjectSide side = ObjectSide::none;
    std::vector<int> corners; ///< ids, in the order of the line; they count before `side`
    MarkColour colour = MarkColour::white;
    double width = 0.0; ///< where a file does not tell it, that of marks of its weight
    double lineLength = 0.0, spaceLength = 0.0; ///< of a dash, and between two; either 0: without gaps
    double startOffset = 0.0,
           stopOffset = 0.0; ///< from the ends of the side or of the line to those of the paint
};

/// Something beside or on the road.
/// Source: ASAM OpenDRIVE 1.8, 13 (objects).
struct RoadObject : RoadItem
{
    double validLength = 0.0;
    double length = 0.0, radius = 0.0;
    bool isPerpendicularToRoad = false;
    std::vector<ObjectOutline> outlines;
    std::vector<ObjectRepeat> repeats;
    std::vector<ObjectMarking> markings;
    std::string parkingAccess; ///< of a parkingSpace
};

enum class StructureKind
{
    bridge,
    tunnel,
};

/// A bridge or a tunnel: the road from s to s + length lies on it or in it.
struct RoadStructure
{
    StructureKind kind = StructureKind::bridge;
    std::string id, name, type;
    double s = 0.0, length = 0.0;
    double lighting = 0.0, daylight = 0.0; ///< tunnels, 0 to 1
    std::vector<LaneValidity> validities;
    int line = 0;
};

} // namespace osgRoads::core
