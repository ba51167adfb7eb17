// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "worldmaking/map/StreetMap.h"
#include "worldmaking/map/TagCounts.h"
#include "worldmaking/streets/LaneTags.h"
#include "worldmaking/streets/WayLevel.h"

namespace worldmaking
{

/// What a street for cars is like, along a piece of it. Units: metres, km/h, metres per metre.
struct StreetTraits
{
    std::string name;
    std::string kind;      ///< the value of highway: residential, primary_link …; busway: for buses alone
    std::string roadType;  ///< the word of OpenDRIVE: motorway, rural, town …
    int importance = 0;    ///< 0 service … 8 motorway; a link has that of its road
    int forwardLanes = 1;  ///< lanes in the direction of the way
    int backwardLanes = 1; ///< against it; 0: one way
    /// between them, for both directions: a single track, a lane for turns to the left
    int sharedLanes = 0;
    LaneSet forwardBusLanes = 0, backwardBusLanes = 0; ///< of the lanes: for buses alone
    double laneWidthM = 2.75;
    double shoulderM = 0.0;
    bool hasLeftSidewalk = false, hasRightSidewalk = false;
    CycleWay leftCycles = CycleWay::none, rightCycles = CycleWay::none;
    /// painted before crossings, from left to right as a driver sees the lanes; empty: none
    std::vector<std::string> forwardArrows, backwardArrows;
    bool hasCentreMark = false, hasEdgeMarks = false;
    double speedKmh = 50.0;                       ///< the greater of both directions
    double forwardKmh = 50.0, backwardKmh = 50.0; ///< of each
    double steepest = 0.15;                       ///< grade that its class allows
    StreetPlace place = StreetPlace::ground;
    int layer = 0;        ///< among ways that cross
    bool isTrack = false; ///< a railway (Tracks.h): its heights are those of the formation
    bool hasWire = false; ///< a contact wire above a track

    /// Whether cars of both directions share all lanes.
    bool isSingleTrack() const { return sharedLanes > 0 && forwardLanes + backwardLanes == 0; }
    /// Whether all of it is for buses alone.
    bool isForBuses() const { return kind == "busway"; }
    /// The speeds of its lanes, where both directions differ: forward and backward.
    std::pair<double, double> laneKmh() const
    {
        return forwardKmh == backwardKmh ? std::pair(0.0, 0.0) : std::pair(forwardKmh, backwardKmh);
    }
    WayLevel level() const { return {place, layer}; }
    /// The same street seen from its other end.
    StreetTraits reversed() const;
    /// Whether both have the same lanes, so that no lane begins or ends between them.
    bool hasSameLanes(const StreetTraits& other) const;
};

inline constexpr double kCycleLaneM = 1.5; ///< of the paving

/// Returns the traits of a way; nothing for one that cars cannot or must not use (footpaths, tracks, closed
/// and planned roads); the lanes of a busway are for buses. Numbers that a tag lacks or has wrong are those
/// of its class. `approximated`: counts tags that are taken for something else; may be null.
/// Sources: the OpenStreetMap wiki, *Key:highway*, *Key:lanes*, *Key:oneway*, *Key:maxspeed*; lane widths and
/// grades after RAL 2012 (Germany) and TxDOT, *Roadway Design Manual*, 2022, 2-3 (local roads in rolling and
/// mountainous country).
std::optional<StreetTraits> traitsOf(const Tags& tags, TagCounts* approximated = nullptr);

/// Whether a way is a street that is there, but not for cars.
bool isClosedStreet(const Tags& tags);

} // namespace worldmaking
