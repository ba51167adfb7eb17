// SPDX-License-Identifier: Apache-2.0
#include "worldmaking/plan/Waters.h"

#include "scenery/buildings/Outline.h"

namespace worldmaking
{

namespace
{

constexpr double kShoreM = 0.5;

} // namespace

bool isWater(const LandShape& shape)
{
    if (shape.form != ShapeForm::area) return false;
    const std::string_view use = valueOf(shape.tags, "landuse"), way = valueOf(shape.tags, "waterway");
    return valueOf(shape.tags, "natural") == "water" || use == "reservoir" || use == "basin" ||
           way == "riverbank";
}

Waters::Waters(const LandMap& map, const MapPlane& plane)
{
    for (const LandShape& shape : map.shapes)
    {
        auto rings = isWater(shape) ? plane.toPlan(shape.paths) : std::nullopt;
        if (!rings) continue;
        _grid.add(_outlines.size(), boxOf(rings->front()));
        _outlines.push_back(std::move(*rings));
    }
}

bool Waters::contain(const glm::dvec2& place) const
{
    bool isInside = false;
    _grid.near({place - kShoreM, place + kShoreM},
               [&](std::size_t i)
               {
                   for (const glm::dvec2 side :
                        {glm::dvec2(0, 0), {kShoreM, 0}, {-kShoreM, 0}, {0, kShoreM}, {0, -kShoreM}})
                       isInside = isInside || scenery::isWithin(_outlines[i], place + side);
               });
    return isInside;
}

} // namespace worldmaking
