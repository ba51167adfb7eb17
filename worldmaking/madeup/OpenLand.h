// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "worldmaking/madeup/GroundGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// What covers ground that nobody tills and no wood stands on. Frame: the plane.
struct OpenLand
{
    std::vector<PlanRings> grass, rock; ///< outlines with holes; between them the ground has its own look
};

/// Lets grass grow up to about 100 m above the trees' line, and leaves rock bare.
/// The line is no contour: in gullies, on gentle ground and on slopes to the south grass climbs by some
/// hundred metres, on ridges and steep slopes it stays behind, and noise frays it. What is too steep for soil
/// is rock at any height, the more of it the higher it lies.
/// Source: Körner, *Alpine treelines*, 2012, ch. 3 and 4, for what raises and lowers such lines; the numbers
/// were chosen by eye. Cost: linear in the points of the grid.
OpenLand openLandOn(const GroundGrid& ground, double treeLineM, std::uint64_t seed);

} // namespace worldmaking
