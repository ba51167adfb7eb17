// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgPMObjects/core/tessellate/Orientation.h>
#include <osgPMObjects/core/tessellate/PolygonProjection.h>
#include <osgPMObjects/core/tessellate/QuadDiagonal.h>

namespace osgPMObjects::core
{

namespace
{

/// Returns the normals of the triangles on either side of the diagonal from `first`; their lengths are twice
/// the areas.
std::array<glm::dvec3, 2> areaNormals(const Quad& quad, std::uint32_t first)
{
    const auto at = [&](std::uint32_t i) { return quad[(first + i) % 4].position; };
    return {glm::cross(at(1) - at(0), at(2) - at(0)), glm::cross(at(2) - at(0), at(3) - at(0))};
}

double angleBetween(const std::array<glm::dvec3, 2>& normals)
{
    return std::atan2(glm::length(glm::cross(normals[0], normals[1])), glm::dot(normals[0], normals[1]));
}

} // namespace

std::array<bool, 2> diagonalsInside(const Quad& quad, DiagonalRule rule)
{
    std::array<glm::dvec3, 4> corners = {quad[0].position, quad[1].position, quad[2].position,
                                         quad[3].position};
    if (isForHeightFields(rule))
        for (glm::dvec3& corner : corners)
            corner.z = 0.0;
    const std::uint32_t size = 4;
    const auto p = projectPolygon(corners, std::span(&size, 1), ProjectionRule::averageNormal);
    const auto isInside = [&](int first)
    {
        const auto &a = p[first], &b = p[first + 1], &c = p[first + 2], &d = p[(first + 3) % 4];
        return orientation(a, b, c) > 0.0 && orientation(a, c, d) > 0.0;
    };
    return {isInside(0), isInside(1)};
}

double diagonalCost(const Quad& quad, std::uint32_t first, DiagonalRule rule)
{
    const QuadCorner &a = quad[first], &b = quad[first + 2];
    switch (rule)
    {
    case DiagonalRule::leastColourDifference:
        return glm::distance(a.colour, b.colour);
    case DiagonalRule::leastNormalDifference:
        return glm::distance(a.normal, b.normal);
    case DiagonalRule::largestNormalAngle:
        return -angleBetween(areaNormals(quad, first));
    case DiagonalRule::nearestAreas:
    {
        const auto normals = areaNormals(quad, first);
        return std::abs(glm::length(normals[0]) - glm::length(normals[1]));
    }
    case DiagonalRule::nearestHeights:
        return std::abs(a.position.z - b.position.z);
    case DiagonalRule::largestHeightDifference:
        return -std::abs(a.position.z - b.position.z);
    }
    return 0.0;
}

std::optional<std::uint32_t> chooseDiagonal(const Quad& quad, DiagonalRule rule)
{
    const std::array<bool, 2> isInside = diagonalsInside(quad, rule);
    if (!isInside[0] && !isInside[1]) return std::nullopt;
    if (!isInside[0] || !isInside[1]) return isInside[0] ? 0u : 1u;
    return diagonalCost(quad, 1, rule) < diagonalCost(quad, 0, rule) ? 1u : 0u;
}

} // namespace osgPMObjects::core
