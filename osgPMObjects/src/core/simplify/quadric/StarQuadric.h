// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/simplify/Quadric.h>

#include "../star/Star.h"

namespace osgPMObjects::core
{

/// What the squared distance from a face counts for, by the face's area (half its doubleArea squared to the power):
/// doubleArea^areaPower + floor^areaPower. A power of 1 is the mean squared distance, 2 the squared change of the volume (Lindstrom–Turk). The
/// floor is an area: it keeps slender features, whose area says little, and so the largest error down.
struct AreaWeight
{
    double areaPower = 1.0;
    double floor = 0.0;

    double of(double doubleArea) const;
};

/// The quadric of the faces around a position as they are now, its origin there; of the lines of open edges; of edges that are
/// folded so sharply that their faces lie on each other, which would else vanish for nothing; and of borders.
/// `isBorder` tells where two faces beside an edge differ in what they show: those edges count as open ones do.
/// Source: Lindstrom and Turk, "Fast and memory efficient polygonal simplification" (1998), §3 (memoryless: volume and
/// boundary), written as Garland and Heckbert's quadrics (1997); ours are the weight by area, its floor, and folds.
template<class IsBorder>
Quadric starQuadric(const Star& star, std::span<const glm::dvec3> positions, const AreaWeight& weight,
                    const IsBorder& isBorder);

/// Of one edge of a star: how much of an open edge it is.
double foldOf(const Star& star, std::span<const Star::Side> sides);

/// Adds the line of an edge, seen in the plane of each face beside it.
void addLine(Quadric& quadric, const Star& star, std::span<const Star::Side> sides, const glm::dvec3& edge,
             double weight);

template<class IsBorder>
Quadric starQuadric(const Star& star, std::span<const glm::dvec3> positions, const AreaWeight& weight,
                    const IsBorder& isBorder)
{
    Quadric quadric;
    for (const Star::Spoked& spoked : star.faces)
        quadric.addPlane(spoked.normal, weight.of(spoked.doubleArea));
    for (std::size_t at = 0; at < star.sides.size();)
    {
        const auto sides = star.sidesFrom(at);
        const double openness = isBorder(sides) ? 1.0 : foldOf(star, sides);
        const glm::dvec3 edge = positions[sides.front().to] - positions[star.middle];
        if (openness > 0.0) addLine(quadric, star, sides, edge, openness * weight.of(glm::dot(edge, edge)));
        at += sides.size();
    }
    return quadric;
}

} // namespace osgPMObjects::core
