// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "worldmaking/map/LandMap.h"
#include "worldmaking/plan/RoadRoom.h"

namespace worldmaking
{

/// A thing of a made-up map as LandShape has it, but in the plane. Units: metres.
struct MadeShape
{
    ShapeForm form = ShapeForm::area;
    PlanRings paths;
    Tags tags;
};

using MadeShapes = std::vector<MadeShape>;

inline MadeShape areaShape(PlanRings rings, Tags tags)
{
    return {ShapeForm::area, std::move(rings), std::move(tags)};
}

inline MadeShape lineShape(std::vector<glm::dvec2> line, Tags tags)
{
    return {ShapeForm::line, {std::move(line)}, std::move(tags)};
}

inline MadeShape pointShape(const glm::dvec2& place, Tags tags)
{
    return {ShapeForm::point, {{place}}, std::move(tags)};
}

/// A rectangle about its middle. `along`: unit vector.
inline PlanRings rectangleOf(const glm::dvec2& middle, const glm::dvec2& along, double lengthM, double widthM)
{
    const glm::dvec2 a = 0.5 * lengthM * along, b = 0.5 * widthM * glm::dvec2(-along.y, along.x);
    return {{middle - a - b, middle + a - b, middle + a + b, middle - a + b}};
}

} // namespace worldmaking
