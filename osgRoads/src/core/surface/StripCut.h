// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "ChunkRows.h"

namespace osgRoads::core
{

/// Tells how far a strip is drawn of which other roads cover a part: MeshVertex::present of its borders,
/// which is interpolated and cut at a half.
class StripCut
{
public:
    StripCut(const JunctionCover& cover, const ChunkRows& rows) : _cover(cover), _rows(rows) {}

    /// A place of a cross-section: a border of a strip, and the column of its other border.
    struct Place
    {
        std::size_t row = 0, column = 0, across = 0;
    };

    /// Returns what is drawn at a covered border of a verge. The cut lies a little beyond the place where the
    /// cover begins, and never before the half of the way between two vertices: so the verges of two roads
    /// that draw near each other fill what lies between them, as far as its tip. What they have too much lies
    /// below the other road, since verges fall outwards.
    std::uint8_t ofVerge(const Place& place, bool isCoveredAcross) const;

    /// Whether the inner border of a verge, `across`, lies higher than the lanes: it begins at a sidewalk.
    bool isRaised(const Place& place) const;

    /// What is drawn at the covered border of a strip, and at its other one.
    struct Ends
    {
        std::uint8_t covered = 0, across = 255;
    };

    /// The same of a verge that isRaised(): it would lie over the other road's lanes, so it ends where these
    /// begin.
    Ends ofRaisedVerge(const Place& place) const;

    /// Returns what is drawn at a border of a lane that carriageways cover, while its other border is free:
    /// the cut lies where the cover begins, or at the half of the lane where that is less.
    std::uint8_t ofLane(const Place& place) const;

private:
    double tBetween(const Place& place, double way) const;
    bool isCovered(const ChunkRow& row, std::size_t column) const;

    const JunctionCover& _cover;
    const ChunkRows& _rows;
};

} // namespace osgRoads::core
