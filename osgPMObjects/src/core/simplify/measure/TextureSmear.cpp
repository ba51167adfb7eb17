// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/simplify/TextureSmear.h>

#include "../patch/Shares.h"
#include "TexturedFace.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kLeastSmearPointsAThread = 1024;

/// Coordinates count as those of a face within this distance of it: two texels of a texture of 1024 × 1024.
constexpr double kSameTexCoord = 2.0 / 1024.0;

} // namespace

class TextureSmearMeter::Chart
{
public:
    Chart(const MeasuredSurface& original, const std::vector<std::uint32_t>& triangles)
    {
        const Mesh& mesh = original.mesh();
        for (const std::uint32_t t : triangles)
        {
            const auto first = static_cast<std::uint32_t>(_texCoords.size());
            _flat.push_back({first, first + 1, first + 2});
            for (int corner = 0; corner < 3; ++corner)
            {
                const std::uint32_t wedge = mesh.faces[original.faces()[t]].wedges[corner];
                _texCoords.emplace_back(mesh.texCoords[0][wedge], 0.0f);
                _places.push_back(mesh.positions[original.triangles()[t][corner]]);
            }
        }
        _tree.emplace(_texCoords, _flat);
    }

    /// Returns the distance of a point from the nearest place with these texture coordinates; infinite where
    /// there is none.
    double distance(const glm::dvec3& point, const glm::dvec2& texCoord) const
    {
        const glm::dvec3 at(texCoord, 0.0);
        double bound = kSameTexCoord * kSameTexCoord, least = std::numeric_limits<double>::infinity();
        _tree->visitNear(at, bound,
                         [&](std::uint32_t triangle)
                         {
                             const std::array corners = cornersOf(_texCoords, triangle);
                             const glm::dvec3 near = nearestPoint(at, corners[0], corners[1], corners[2]);
                             if (glm::length(near - at) > kSameTexCoord) return;
                             least = std::min(least, distanceTo(triangle, near, point));
                         });
        return least;
    }

private:
    static std::array<glm::dvec3, 3> cornersOf(const std::vector<glm::dvec3>& points, std::uint32_t triangle)
    {
        return {points[3 * triangle], points[3 * triangle + 1], points[3 * triangle + 2]};
    }

    double distanceTo(std::uint32_t triangle, const glm::dvec3& texCoord, const glm::dvec3& point) const
    {
        const std::array places = cornersOf(_places, triangle), corners = cornersOf(_texCoords, triangle);
        const glm::dvec3 cross = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (!(glm::length(cross) > 0.0)) // no area in the image: all of the face has these coordinates
            return glm::length(nearestPoint(point, places[0], places[1], places[2]) - point);
        const auto shares = sharesOf(texCoord, corners);
        return glm::length(shares[0] * places[0] + shares[1] * places[1] + shares[2] * places[2] - point);
    }

    std::vector<glm::dvec3> _texCoords, _places; ///< by corner of _flat; the third texture coordinate is 0
    std::vector<Triangle> _flat;
    std::optional<TriangleTree> _tree;
};

TextureSmearMeter::TextureSmearMeter(const MeasuredSurface& original)
    : _charts(original.mesh().materials.size())
{
    const Mesh& mesh = original.mesh();
    std::vector<std::vector<std::uint32_t>> triangles(mesh.materials.size());
    for (std::uint32_t t = 0; t < original.triangles().size(); ++t)
        triangles[mesh.faces[original.faces()[t]].material].push_back(t);
    for (std::uint32_t m = 0; m < mesh.materials.size(); ++m)
        if (isTextured(mesh, m) && !triangles[m].empty())
            _charts[m] = std::make_unique<Chart>(original, triangles[m]);
}

TextureSmearMeter::~TextureSmearMeter() = default;

std::optional<TextureSmear> TextureSmearMeter::measure(const MeasuredSurface& level, double allowed) const
{
    const Mesh& mesh = level.mesh();
    const std::vector<SurfacePoint>& points = level.spreadPoints();
    std::vector<double> distances(points.size(), -1.0); // negative: no texture there
    parallelShares(
        points.size(), kLeastSmearPointsAThread,
        [&](std::size_t first, std::size_t last, std::size_t)
        {
            for (std::size_t i = first; i < last; ++i)
            {
                const SurfacePoint& point = points[i];
                const std::uint32_t face = level.faces()[point.triangle],
                                    material = mesh.faces[face].material;
                if (material >= _charts.size() || !_charts[material] || !isTextured(mesh, material)) continue;
                distances[i] = _charts[material]->distance(point.position,
                                                           texCoordAt(mesh, face, point.second, point.third));
            }
        });
    std::erase_if(distances, [](double d) { return d < 0.0; });
    if (distances.empty()) return std::nullopt;
    std::sort(distances.begin(), distances.end());
    const auto far = distances.end() - std::upper_bound(distances.begin(), distances.end(), allowed);
    TextureSmear smear{0.0, 0.0, static_cast<double>(far) / static_cast<double>(distances.size()),
                       distances.size()};
    distances.erase(
        std::lower_bound(distances.begin(), distances.end(), std::numeric_limits<double>::infinity()),
        distances.end());
    if (distances.empty()) return smear;
    smear.mean =
        std::accumulate(distances.begin(), distances.end(), 0.0) / static_cast<double>(distances.size());
    smear.ofNinetyNine = distances[(distances.size() - 1) * 99 / 100];
    return smear;
}

} // namespace osgPMObjects::core
