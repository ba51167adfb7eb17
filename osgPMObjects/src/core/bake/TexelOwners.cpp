// SPDX-License-Identifier: Apache-2.0
#include "TexelOwners.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/TriangleTree.h>

namespace osgPMObjects::core
{

namespace
{

/// The largest distance of a texel's centre from a point of the chart whose filtering reads it: half a
/// diagonal to the texel's corner, another to the centres around it.
constexpr double kReachPx = 1.5;
constexpr double kLeastArea = 1e-12; ///< of a triangle in texels

glm::dvec2 nearestTo(const FlatTriangle& t, const glm::dvec2& p)
{
    return nearestPoint({p, 0.0}, {t[0], 0.0}, {t[1], 0.0}, {t[2], 0.0});
}

} // namespace

FlatTriangle inAtlas(const Mesh& mesh, const Atlas& atlas, std::uint32_t face)
{
    const Face& f = mesh.faces[face];
    return {atlas.texelOf(face, mesh.at(f, 0)), atlas.texelOf(face, mesh.at(f, 1)),
            atlas.texelOf(face, mesh.at(f, 2))};
}

glm::dvec3 weightsAt(const FlatTriangle& t, const glm::dvec2& p)
{
    const glm::dvec2 at = nearestTo(t, p);
    const double whole = doubleArea(t[0], t[1], t[2]);
    const double a = std::clamp(doubleArea(at, t[1], t[2]) / whole, 0.0, 1.0);
    const double b = std::clamp(doubleArea(t[0], at, t[2]) / whole, 0.0, 1.0 - a);
    return {a, b, 1.0 - a - b};
}

TexelOwners texelOwners(const Mesh& mesh, const Atlas& atlas)
{
    const auto size = static_cast<std::size_t>(atlas.sizePx);
    TexelOwners owners;
    owners.faces.assign(size * size, TexelOwners::kNone);
    std::vector<float> distances(size * size, static_cast<float>(kReachPx));
    const auto texel = [&](double x)
    { return static_cast<std::size_t>(std::clamp(std::floor(x), 0.0, atlas.sizePx - 1.0)); };
    for (std::uint32_t f = 0; f < mesh.faces.size(); ++f)
    {
        const FlatTriangle t = inAtlas(mesh, atlas, f);
        if (doubleArea(t[0], t[1], t[2]) <= kLeastArea) continue;
        const glm::dvec2 low = glm::min(glm::min(t[0], t[1]), t[2]) - kReachPx;
        const glm::dvec2 high = glm::max(glm::max(t[0], t[1]), t[2]) + kReachPx;
        for (std::size_t y = texel(low.y); y <= texel(high.y); ++y)
            for (std::size_t x = texel(low.x); x <= texel(high.x); ++x)
            {
                const glm::dvec2 centre(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
                const auto distance = static_cast<float>(glm::length(nearestTo(t, centre) - centre));
                if (distance >= distances[y * size + x]) continue;
                distances[y * size + x] = distance;
                owners.faces[y * size + x] = f;
            }
    }
    // In a triangle the nearest point differs from the point itself by rounding only.
    owners.covered = static_cast<std::size_t>(
        std::count_if(distances.begin(), distances.end(), [](float d) { return d < 1e-4f; }));
    return owners;
}

} // namespace osgPMObjects::core
