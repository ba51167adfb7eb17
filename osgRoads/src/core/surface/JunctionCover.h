// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgRoads/core/place/PlacedNetwork.h>

namespace osgRoads::core
{

/// Surfaces less than this above each other are one place.
inline constexpr double kSameLevelM = 1.0;

/// Tells where the carriageways of other roads cover what a road has beside its own carriageway: connecting
/// roads lie over each other and over the verges of their neighbours.
class JunctionCover
{
public:
    JunctionCover(const PlacedNetwork& network, int road);

    /// Whether anything of this road can be covered.
    bool canCover() const { return _canCover; }
    /// Whether the road's own marks may be covered: it connects others in a junction.
    bool canCoverMarks() const { return _isConnecting; }

    /// Whether the road itself tells at s where the paving of its junction ends: it has a lane of the type
    /// special.
    bool hasOwnPaving(double s) const;

    /// Whether one side of the road has no verge, since the paving of its junction goes on there: it is the
    /// left side of a road that bears an edge of the paving, both sides of other roads beside such ones.
    bool isWithinPaving(int side) const { return side > 0 ? _isLeftWithin : _isRightWithin; }

    /// Whether another road's lanes come within `radiusM` of the reference line at s in the plan view. Where
    /// none does, nothing within that distance is covered.
    bool isNearOther(double s, double radiusM) const;

    /// What covers another road: its carriageway, or all of its lanes that are paved.
    enum class By
    {
        carriageway,
        paving,
    };

    /// Whether another road lies at (s, t) of this one, less than 1 m higher or lower.
    bool covers(double s, double t, By by = By::carriageway) const;

    /// Whether a verge is a gap between carriageways of one junction: a driving lane of another road lies at
    /// most 5 m outwards of (s, t).
    /// `side`: 1 to the left.
    bool isGap(double s, double t, int side) const;

private:
    const PlacedNetwork& _network;
    int _road;
    bool _isConnecting, _canCover, _bearsEdge;
    bool _isLeftWithin = false, _isRightWithin = false;
};

} // namespace osgRoads::core
