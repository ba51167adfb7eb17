// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "scenery/buildings/Outline.h"
#include "worldmaking/plan/PlanGrid.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// Areas of the plane, asked for a place.
class AreaSet
{
public:
    void add(PlanRings rings)
    {
        _grid.add(_areas.size(), boxOf(rings.front()));
        _areas.push_back(std::move(rings));
    }

    bool contains(const glm::dvec2& place) const
    {
        bool isInside = false;
        _grid.near({place, place},
                   [&](std::size_t i) { isInside = isInside || scenery::isWithin(_areas[i], place); });
        return isInside;
    }

    const std::vector<PlanRings>& all() const { return _areas; }

    /// Calls `use(rings)` for areas whose box meets another.
    template<class Use>
    void near(const MapBox& box, const Use& use) const
    {
        _grid.near(box, [&](std::size_t i) { use(_areas[i]); });
    }

private:
    std::vector<PlanRings> _areas;
    PlanGrid _grid;
};

} // namespace worldmaking
