// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <thread>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <osgPMObjects/core/Parallel.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/simplify/TextureDrift.h>

#include "TexturedFace.h"

namespace osgPMObjects::core
{

namespace
{

constexpr std::size_t kLeastCornersAThread = 1024;

/// Faces count as equally near within this share of the diagonal, or of the distance.
constexpr double kSameDistance = 1e-6, kSameShare = 1e-3;

glm::dvec3 crossOf(const Mesh& mesh, const Triangle& t)
{
    return glm::cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                      mesh.positions[t[2]] - mesh.positions[t[0]]);
}

} // namespace

class TextureDriftMeter::Surface
{
public:
    Surface(const Mesh& mesh, std::vector<Triangle> triangles, std::vector<std::uint32_t> faces)
        : _mesh(mesh),
          _triangles(std::move(triangles)),
          _faces(std::move(faces)),
          _slack(kSameDistance * diagonalOf(mesh)),
          _tree(mesh.positions, _triangles)
    {
        for (const Triangle& t : _triangles)
            _crosses.push_back(crossOf(mesh, t));
    }

    /// Returns the least difference between the given coordinates and those at the nearest points of faces
    /// oriented to `facing`. `hint`: a triangle that may be near; on return the nearest.
    double difference(const glm::dvec3& point, const glm::dvec3& facing, const glm::dvec2& texCoord,
                      std::uint32_t& hint) const
    {
        const double found = search(point, texCoord, hint,
                                    [&](std::uint32_t t) { return glm::dot(_crosses[t], facing) > 0.0; });
        return std::isfinite(found) ? found
                                    : search(point, texCoord, hint, [](std::uint32_t) { return true; });
    }

private:
    struct Place
    {
        double distance;
        std::uint32_t triangle;
        glm::dvec3 point;
    };

    double widened(double distance) const { return distance * (1.0 + kSameShare) + _slack; }

    Place placeOn(std::uint32_t triangle, const glm::dvec3& point) const
    {
        const Triangle& t = _triangles[triangle];
        const glm::dvec3 near =
            nearestPoint(point, _mesh.positions[t[0]], _mesh.positions[t[1]], _mesh.positions[t[2]]);
        return {glm::length(point - near), triangle, near};
    }

    template<class Counts>
    double search(const glm::dvec3& point, const glm::dvec2& texCoord, std::uint32_t& hint,
                  const Counts& counts) const
    {
        double nearest = std::numeric_limits<double>::infinity();
        if (hint < _triangles.size() && counts(hint)) nearest = placeOn(hint, point).distance;
        double squaredBound = widened(nearest) * widened(nearest);
        thread_local std::vector<Place> places;
        places.clear();
        _tree.visitNear(point, squaredBound,
                        [&](std::uint32_t triangle)
                        {
                            if (!counts(triangle)) return;
                            const Place place = placeOn(triangle, point);
                            if (place.distance > widened(nearest)) return;
                            places.push_back(place);
                            if (place.distance >= nearest) return;
                            nearest = place.distance;
                            hint = triangle;
                            squaredBound = widened(nearest) * widened(nearest);
                        });
        double least = std::numeric_limits<double>::infinity();
        for (const Place& place : places)
            if (place.distance <= widened(nearest))
                least = std::min(least, glm::length(texCoordOf(place) - texCoord));
        return least;
    }

    glm::dvec2 texCoordOf(const Place& place) const
    {
        const Triangle& t = _triangles[place.triangle];
        const glm::dvec3 &a = _mesh.positions[t[0]], &b = _mesh.positions[t[1]], &c = _mesh.positions[t[2]];
        const glm::dvec3& cross = _crosses[place.triangle];
        const double square = glm::dot(cross, cross);
        return texCoordAt(_mesh, _faces[place.triangle],
                          glm::dot(glm::cross(place.point - a, c - a), cross) / square,
                          glm::dot(glm::cross(b - a, place.point - a), cross) / square);
    }

    const Mesh& _mesh;
    std::vector<Triangle> _triangles;
    std::vector<std::uint32_t> _faces;
    std::vector<glm::dvec3> _crosses; ///< by triangle
    double _slack;
    TriangleTree _tree;
};

TextureDriftMeter::TextureDriftMeter(const MeasuredSurface& original)
    : _surfaces(original.mesh().materials.size())
{
    const Mesh& mesh = original.mesh();
    std::vector<std::vector<Triangle>> triangles(mesh.materials.size());
    std::vector<std::vector<std::uint32_t>> faces(mesh.materials.size());
    for (std::size_t t = 0; t < original.triangles().size(); ++t)
    {
        const std::uint32_t face = original.faces()[t], material = mesh.faces[face].material;
        triangles[material].push_back(original.triangles()[t]);
        faces[material].push_back(face);
    }
    for (std::uint32_t m = 0; m < mesh.materials.size(); ++m)
        if (isTextured(mesh, m) && !faces[m].empty())
            _surfaces[m] = std::make_unique<Surface>(mesh, std::move(triangles[m]), std::move(faces[m]));
}

TextureDriftMeter::~TextureDriftMeter() = default;

std::optional<TextureDrift> TextureDriftMeter::measure(const MeasuredSurface& level) const
{
    const Mesh& mesh = level.mesh();
    const std::vector<SurfacePoint>& points = level.spreadPoints();
    std::vector<double> drifts(points.size(), -1.0); // negative: no texture there
    parallelShares(points.size(), kLeastCornersAThread,
                   [&](std::size_t first, std::size_t last, std::size_t)
                   {
                       std::uint32_t hint = 0;
                       for (std::size_t i = first; i < last; ++i)
                       {
                           const SurfacePoint& point = points[i];
                           const std::uint32_t face = level.faces()[point.triangle],
                                               material = mesh.faces[face].material;
                           if (material >= _surfaces.size() || !_surfaces[material] ||
                               !isTextured(mesh, material))
                               continue;
                           drifts[i] = TextureDrift::kTexelsPerUnit *
                                       _surfaces[material]->difference(
                                           point.position, crossOf(mesh, level.triangles()[point.triangle]),
                                           texCoordAt(mesh, face, point.second, point.third), hint);
                       }
                   });
    std::erase_if(drifts, [](double d) { return d < 0.0; });
    if (drifts.empty()) return std::nullopt;
    std::sort(drifts.begin(), drifts.end());
    const auto visible =
        drifts.end() - std::upper_bound(drifts.begin(), drifts.end(), TextureDrift::kVisibleTexels);
    const auto count = static_cast<double>(drifts.size());
    return TextureDrift{std::accumulate(drifts.begin(), drifts.end(), 0.0) / count,
                        drifts[(drifts.size() - 1) * 99 / 100], drifts.back(),
                        static_cast<double>(visible) / count, drifts.size()};
}

} // namespace osgPMObjects::core
