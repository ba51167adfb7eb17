// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "worldmaking/map/StreetMap.h"

namespace worldmaking
{

/// What lies on a piece of a street.
enum class StreetPlace
{
    ground,
    bridge,
    tunnel,
};

/// What a street for cars is like, along a piece of it. Units: metres, km/h, metres per metre.
struct StreetTraits
{
    std::string name;
    std::string kind;      ///< the value of highway: residential, primary_link …
    std::string roadType;  ///< the word of OpenDRIVE: motorway, rural, town …
    int importance = 0;    ///< 0 service … 8 motorway; a link has that of its road
    int forwardLanes = 1;  ///< lanes in the direction of the way
    int backwardLanes = 1; ///< against it; 0: one way
    double laneWidthM = 2.75;
    double shoulderM = 0.0;
    bool hasLeftSidewalk = false, hasRightSidewalk = false;
    bool hasCentreMark = false, hasEdgeMarks = false;
    double speedKmh = 50.0;
    double steepest = 0.15; ///< grade that its class allows
    StreetPlace place = StreetPlace::ground;

    /// The same street seen from its other end.
    StreetTraits reversed() const;
    /// Whether both have the same lanes, so that no lane begins or ends between them.
    bool hasSameLanes(const StreetTraits& other) const;
};

/// Returns the traits of a way; nothing for one that cars cannot or must not use (footpaths, tracks, closed
/// and planned roads). Numbers that a tag lacks or has wrong are those of its class.
/// Sources: the OpenStreetMap wiki, *Key:highway*, *Key:lanes*, *Key:oneway*; lane widths and grades after
/// RAL 2012 (Germany) and TxDOT, *Roadway Design Manual*, 2022, 2-3 (local roads in rolling and mountainous
/// country).
std::optional<StreetTraits> traitsOf(const Tags& tags);

} // namespace worldmaking
