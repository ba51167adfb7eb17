// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include <osgPMObjects/core/simplify/Quadric.h>

#include "../star/Star.h"

namespace osgPMObjects::core
{

/// The weight of a face's squared distance, by its area: doubleArea^areaPower + floor^areaPower. A power of 1
/// gives the mean squared distance, 2 the squared change of volume (Lindstrom and Turk). The floor is an
/// area; it protects slender features of little area, and so limits the largest error.
struct AreaWeight
{
    double areaPower = 1.0;
    double floor = 0.0;

    double of(double doubleArea) const;
};

/// Computes the quadric of a position from its current faces, with its origin there: of the face planes; of
/// the lines of open edges and borders; and of edges so sharply folded that their faces coincide, which would
/// else vanish at no cost.
/// `isBorder(…)`: whether two faces beside an edge differ in appearance; such edges count as open.
/// Source: Lindstrom and Turk, *Fast and memory efficient polygonal simplification* (1998), section 3
/// (memoryless: volume and boundary), in the form of Garland and Heckbert, *Surface simplification using
/// quadric error metrics* (1997). Differs: weight by area, its floor, and folds.
template<class IsBorder>
Quadric starQuadric(const Star& star, std::span<const glm::dvec3> positions, const AreaWeight& weight,
                    const IsBorder& isBorder);

/// Returns the weight of an edge of a star as an open edge, 0 to 1.
double foldOf(const Star& star, std::span<const Star::Side> sides);

/// Adds the line of an edge, within the plane of each face beside it.
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
