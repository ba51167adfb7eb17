// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <osgPMObjects/core/tessellate/PolygonProjection.h>
#include <osgPMObjects/core/tessellate/WarpedQuad.h>

namespace osgPMObjects::core
{

namespace
{

template<class V>
V bilinear(const std::array<V, 4>& corners, const glm::dvec2& shares)
{
    return glm::mix(glm::mix(corners[0], corners[1], shares.x), glm::mix(corners[3], corners[2], shares.x),
                    shares.y);
}

/// Returns the deviation from a parallelogram.
template<class V>
double warp(const std::array<V, 4>& corners)
{
    return glm::length(corners[0] - corners[1] + corners[2] - corners[3]);
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Returns the largest change of texture coordinates a unit of length in the patch; infinite if it is not
/// convex. The matrix from positions to texture is that from (s, t) to texture times the inverse of that from
/// (s, t) to positions. The determinant of the latter is linear, so the extremes are at corners.
double texturePerLength(const TexturedQuad& quad)
{
    const glm::dvec3 normal = areaVector(quad.positions);
    double texture2 = 0.0, length2 = 0.0, area = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 4; ++i)
    {
        const int behind = (i + 1) % 4, before = (i + 3) % 4;
        const glm::dvec3 e = quad.positions[behind] - quad.positions[i],
                         f = quad.positions[before] - quad.positions[i];
        const glm::dvec2 u = quad.texCoords[behind] - quad.texCoords[i],
                         v = quad.texCoords[before] - quad.texCoords[i];
        texture2 = std::max(texture2, glm::dot(u, u) + glm::dot(v, v));
        length2 = std::max(length2, glm::dot(e, e) + glm::dot(f, f));
        area = std::min(area, glm::dot(glm::cross(e, f), normal) / glm::length(normal));
    }
    return area > 0.0 ? std::sqrt(texture2 * length2) / area : std::numeric_limits<double>::infinity();
}

/// Projects the quad and a position in it along the average normal.
std::vector<glm::dvec2> seenFlat(const TexturedQuad& quad, const glm::dvec3& position)
{
    const std::array<glm::dvec3, 5> all = {quad.positions[0], quad.positions[1], quad.positions[2],
                                           quad.positions[3], position};
    const std::array<std::uint32_t, 2> sizes = {4, 1};
    return projectPolygon(all, sizes, ProjectionRule::averageNormal);
}

/// Returns the shares (s, t) of the bilinear patch at the last point of `quad`. Eliminating s from p = a + s
/// e + t f + s t g leaves a quadratic equation in t.
std::optional<glm::dvec2> sharesAt(std::span<const glm::dvec2> p)
{
    constexpr double kSlack = 1e-9; // rounding may put a position on the border outside
    const glm::dvec2 e = p[1] - p[0], f = p[3] - p[0], g = p[0] - p[1] + p[2] - p[3], h = p[4] - p[0];
    const double a = cross(g, f), b = cross(e, f) + cross(h, g), c = cross(h, e);
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return std::nullopt;
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    for (const double t : {a != 0.0 ? q / a : -1.0, q != 0.0 ? c / q : (c == 0.0 ? 0.0 : -1.0)})
    {
        if (!(t >= -kSlack && t <= 1.0 + kSlack)) continue;
        const glm::dvec2 along = e + t * g, rest = h - t * f;
        const double length2 = glm::dot(along, along);
        const double s = length2 > 0.0 ? glm::dot(rest, along) / length2 : 0.0;
        if (s >= -kSlack && s <= 1.0 + kSlack)
            return glm::dvec2(std::clamp(s, 0.0, 1.0), std::clamp(t, 0.0, 1.0));
    }
    return std::nullopt;
}

/// Returns for each corner of a flat quad the q of its projective map to a square: the length of its diagonal
/// over that of the part beyond the crossing; nothing if the diagonals do not meet inside.
std::optional<std::array<double, 4>> divisorsOf(std::span<const glm::dvec2> p)
{
    const glm::dvec2 d = p[2] - p[0], e = p[3] - p[1], between = p[1] - p[0];
    const double determinant = cross(d, e);
    const double s = cross(between, e) / determinant, t = cross(between, d) / determinant;
    if (!(s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0)) return std::nullopt;
    return std::array{1.0 / (1.0 - s), 1.0 / (1.0 - t), 1.0 / s, 1.0 / t};
}

} // namespace

glm::dvec3 positionAt(const TexturedQuad& quad, const glm::dvec2& shares)
{
    return bilinear(quad.positions, shares);
}

glm::dvec2 texCoordAt(const TexturedQuad& quad, const glm::dvec2& shares)
{
    return bilinear(quad.texCoords, shares);
}

foundation::Result<QuadGrid> meshQuad(const TexturedQuad& quad, double tolerance, std::uint32_t mostCells)
{
    if (!(tolerance > 0.0))
        return foundation::Error{"textured quad", "a tolerance of " + std::to_string(tolerance),
                                 "give one above zero"};
    const double warped = warp(quad.positions);
    const double drift =
        0.25 * (warp(quad.texCoords) + (warped > 0.0 ? warped * texturePerLength(quad) : 0.0));
    const double cells = std::max(std::ceil(std::sqrt(drift / tolerance)), 1.0);
    if (!(cells <= mostCells))
        return foundation::Error{
            "textured quad", "more than " + std::to_string(mostCells) + " cells along a side would be needed",
            "allow a larger tolerance; a quad that is not convex has to be divided"};
    QuadGrid grid;
    const auto n = grid.cells = static_cast<std::uint32_t>(cells);
    for (std::uint32_t row = 0; row <= n; ++row)
        for (std::uint32_t column = 0; column <= n; ++column)
        {
            const glm::dvec2 shares = glm::dvec2(column, row) / static_cast<double>(n);
            grid.positions.push_back(positionAt(quad, shares));
            grid.texCoords.push_back(texCoordAt(quad, shares));
            if (row == n || column == n) continue;
            const std::uint32_t here = row * (n + 1) + column, above = here + n + 1;
            grid.triangles.push_back({here, here + 1, above + 1});
            grid.triangles.push_back({here, above + 1, above});
        }
    return grid;
}

std::optional<glm::dvec2> preWarpedTexCoord(const TexturedQuad& quad, const std::array<double, 4>& weights)
{
    glm::dvec3 position(0.0);
    for (int i = 0; i < 4; ++i)
        position += weights[i] * quad.positions[i];
    const auto shares = sharesAt(seenFlat(quad, position));
    if (!shares) return std::nullopt;
    return texCoordAt(quad, *shares);
}

std::optional<std::array<glm::dvec3, 4>> projectiveTexCoords(const TexturedQuad& quad)
{
    const auto from = divisorsOf(seenFlat(quad, quad.positions[0])), to = divisorsOf(quad.texCoords);
    if (!from || !to) return std::nullopt;
    std::array<glm::dvec3, 4> coords;
    for (std::size_t i = 0; i < 4; ++i)
    {
        const double q = (*from)[i] / (*to)[i];
        coords[i] = glm::dvec3(quad.texCoords[i] * q, q);
    }
    return coords;
}

} // namespace osgPMObjects::core
