// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/map/MapPlane.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Tells whether an area of a map is open water.
bool isWater(const LandShape& shape);

/// The open water of a map, as outlines in the plane.
class Waters
{
public:
    Waters(const LandMap& map, const MapPlane& plane);

    /// Tells whether a place is in water, or half a metre from it.
    bool contain(const glm::dvec2& place) const;

private:
    std::vector<PlanRings> _outlines;
    PlanGrid _grid;
};

} // namespace worldmaking
