// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// The rule that chooses the diagonal of a quad. If both diagonals are equal, the one from corner 0 is
/// chosen.
enum class DiagonalRule
{
    leastColourDifference,   ///< joins corners with the most similar colours: for precomputed lighting
    leastNormalDifference,   ///< joins corners with the most similar normals
    largestNormalAngle,      ///< makes the angle between the two triangles largest: keeps creases
    nearestAreas,            ///< makes the two triangles' areas most similar
    nearestHeights,          ///< joins corners of the most similar heights
    largestHeightDifference, ///< joins corners of the most different heights
};

struct QuadCorner
{
    glm::dvec3 position{0.0}; ///< z is the height
    glm::dvec3 normal{0.0};   ///< unit length; for leastNormalDifference
    glm::dvec4 colour{0.0};   ///< for leastColourDifference
};

using Quad = std::array<QuadCorner, 4>;

/// Tells whether a rule is for height fields. It sees quads from above, however steep; other rules see them
/// along their average normal.
constexpr bool isForHeightFields(DiagonalRule rule)
{
    return rule != DiagonalRule::leastColourDifference && rule != DiagonalRule::leastNormalDifference;
}

/// Tells which diagonals (from corner 0, from corner 1) lie inside the quad as the rule sees it: both for a
/// convex quad, the one at the reflex corner for a concave quad, none for a bow-tie or a quad without area.
std::array<bool, 2> diagonalsInside(const Quad& quad, DiagonalRule rule);

/// Returns what a rule makes least, for the diagonal from corner `first`, 0 or 1.
double diagonalCost(const Quad& quad, std::uint32_t first, DiagonalRule rule);

/// Chooses the diagonal among diagonalsInside(): 0 for 0–2, 1 for 1–3. Nothing: the quad must be cut as a
/// polygon.
/// Source: Jin, *Polygon Techniques*, "shading": least difference, and the four rules for height fields.
std::optional<std::uint32_t> chooseDiagonal(const Quad& quad, DiagonalRule rule);

} // namespace osgPMObjects::core
