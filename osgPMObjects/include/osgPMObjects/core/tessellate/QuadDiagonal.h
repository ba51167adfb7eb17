// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/glm.hpp>

namespace osgPMObjects::core
{

/// By what a quad is cut in two. Of equal diagonals it is the one from corner 0.
enum class DiagonalRule
{
    leastColourDifference, ///< between corners with the most similar colours: for lighting computed beforehand
    leastNormalDifference,   ///< between corners with the most similar normals
    largestNormalAngle,      ///< so that the two triangles have the largest angle between them: creases stay
    nearestAreas,            ///< so that the two triangles have the most similar areas
    nearestHeights,          ///< between corners of the most similar heights
    largestHeightDifference, ///< between corners of the most different heights
};

struct QuadCorner
{
    glm::dvec3 position{0.0}; ///< height: z
    glm::dvec3 normal{0.0};   ///< of unit length, for leastNormalDifference
    glm::dvec4 colour{0.0};   ///< for leastColourDifference
};

using Quad = std::array<QuadCorner, 4>;

/// Whether a rule is one for height fields: these are seen from above, however steep, other quads along their average
/// normal.
constexpr bool isForHeightFields(DiagonalRule rule)
{
    return rule != DiagonalRule::leastColourDifference && rule != DiagonalRule::leastNormalDifference;
}

/// The diagonals that lie inside of the quad, as the rule sees it: from corner 0 and from corner 1. A convex quad has both,
/// a concave one that of its reflex corner, a bow-tie and a quad without area none.
std::array<bool, 2> diagonalsInside(const Quad& quad, DiagonalRule rule);

/// The corner from which the quad is to be cut: 0 (0–2) or 1 (1–3), among diagonalsInside(). Nothing: cut it as a polygon.
/// Source: paper 002, "shading": least difference, and the four ways for height fields.
std::optional<std::uint32_t> chooseDiagonal(const Quad& quad, DiagonalRule rule);

} // namespace osgPMObjects::core
