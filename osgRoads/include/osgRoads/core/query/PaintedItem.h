// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <osgRoads/core/network/RoadObject.h>
#include <osgRoads/core/network/Signal.h>

namespace osgRoads::core
{

/// What a signal or an object paints on the road.
enum class PaintKind
{
    stopLine,
    yieldLine, ///< of short stripes
    crosswalk,
    arrow,
    parkingSpace,
    area,  ///< filled, white
    patch, ///< of newer asphalt
};

/// Returns what a signal paints, or nothing for signals that stand. By the numbers of the German StVO (annex
/// 2), which the country OpenDRIVE shares: 293 crosswalk, 294 stop line, 297 arrows, 341 yield line; 1000003
/// is a crosswalk, too; else by the words of its name.
std::optional<PaintKind> paintKind(const Signal& signal);

/// Returns what an object paints, by its type and subtype.
/// Source: ASAM OpenDRIVE 1.8, 13.1 (types of objects), 13.14 (road mark objects).
std::optional<PaintKind> paintKind(const RoadObject& object);

/// Where the heads of a painted arrow point to.
struct ArrowHeads
{
    bool left = false, ahead = false, right = false;
    int merge = 0; ///< 1: the arrow leads to the lane on the left; -1: on the right

    bool operator==(const ArrowHeads&) const = default;
};

/// Returns the heads that subtype and name tell ("arrowStraightLeft", "SgRMArrowLeft"); straight ahead when
/// they tell none.
ArrowHeads arrowHeads(const RoadItem& item);

} // namespace osgRoads::core
