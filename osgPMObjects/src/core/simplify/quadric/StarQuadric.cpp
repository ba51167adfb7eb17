// SPDX-License-Identifier: Apache-2.0
#include "StarQuadric.h"

#include <cmath>

#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

double AreaWeight::of(double doubleArea) const
{
    const auto power = [this](double area)
    {
        if (areaPower == 1.0) return area;
        return areaPower == 2.0 ? area * area : area * std::sqrt(area);
    };
    return power(doubleArea) + power(floor);
}

double foldOf(const Star& star, std::span<const Star::Side> sides)
{
    if (sides.size() == 1) return 1.0;
    if (sides.size() > 2) return 0.0;
    const double against = -glm::dot(star.faces[sides[0].spoked].normal, star.faces[sides[1].spoked].normal);
    return against > 0.0 ? 0.5 * against * against : 0.0;
}

void addLine(Quadric& quadric, const Star& star, std::span<const Star::Side> sides, const glm::dvec3& edge,
             double weight)
{
    const double length = glm::length(edge);
    if (!(length > 0.0)) return;
    for (const Star::Side& side : sides)
        quadric.addPlane(glm::cross(edge / length, star.faces[side.spoked].normal), weight);
}

} // namespace osgPMObjects::core
