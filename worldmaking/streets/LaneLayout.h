// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <osgRoads/core/network/Lane.h>

#include "worldmaking/streets/StreetTraits.h"

namespace worldmaking
{

inline constexpr double kKerbM = 0.12; ///< of a sidewalk above the lanes

/// The cross-section of a street: its lanes from the centre outwards, and where the centre lies.
/// Traffic keeps to the right. Units: metres.
struct LaneLayout
{
    struct Strip
    {
        osgRoads::core::LaneType type = osgRoads::core::LaneType::driving;
        int order = 0; ///< of its type, from the centre
        double widthM = 0.0;
        osgRoads::core::MarkType outerMark = osgRoads::core::MarkType::none;
        bool isShared = false; ///< both directions use it; it counts to the right side
        bool isForBuses = false;
        double speedKmh = 0.0; ///< 0: that of the road

        bool isSameLane(const Strip& other) const
        {
            return type == other.type && isShared == other.isShared && order == other.order;
        }
    };

    std::vector<Strip> left, right;
    osgRoads::core::MarkType centreMark = osgRoads::core::MarkType::none;
    double offsetM =
        0.0; ///< of the centre, to the left: the middle of the carriageway lies on the map's line

    /// How far the paving reaches from the map's line to its farther side.
    double halfWidthM() const;
};

LaneLayout layoutOf(const StreetTraits& traits);

/// A part of a street with one layout.
struct LayoutPart
{
    double startM = 0.0; ///< along the road
    LaneLayout layout;
};

/// The lanes of a road: where the layout changes, lanes become wider and narrower along a taper, begin with
/// no width and end so.
struct RoadLanes
{
    std::vector<osgRoads::core::LaneSection> sections;
    osgRoads::core::CubicProfile offset;
};

/// `parts`: ascending, the first at 0. Parts that are too short for a taper have a shorter one.
RoadLanes lanesOf(const std::vector<LayoutPart>& parts, double lengthM);

} // namespace worldmaking
