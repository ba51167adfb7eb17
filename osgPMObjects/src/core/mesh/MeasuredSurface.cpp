// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <random>

#include <glm/geometric.hpp>

#include <osgPMObjects/core/mesh/MeasuredSurface.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

namespace osgPMObjects::core
{

MeasuredSurface::MeasuredSurface(const Mesh& mesh, std::size_t spread) : _mesh(mesh), _tree(makeTree())
{
    addFixedPoints();
    addSpreadPoints(spread);
}

TriangleTree MeasuredSurface::makeTree()
{
    const std::vector<Triangle> all = positionTriangles(_mesh);
    const double height = kDegenerateHeight * diagonalOf(_mesh);
    for (std::uint32_t f = 0; f < all.size(); ++f)
    {
        const Triangle& t = all[f];
        if (repeatsCorner(t) || heightOf(at(t, 0), at(t, 1), at(t, 2)) <= height) continue;
        _triangles.push_back(t);
        _faces.push_back(f);
    }
    return {_mesh.positions, _triangles};
}

void MeasuredSurface::addFixedPoints()
{
    std::vector<bool> isUsed(_mesh.positions.size(), false);
    for (const Triangle& t : _triangles)
    {
        _fixedPoints.push_back((at(t, 0) + at(t, 1) + at(t, 2)) / 3.0);
        for (const std::uint32_t p : t)
        {
            if (!isUsed[p]) _fixedPoints.push_back(_mesh.positions[p]);
            isUsed[p] = true;
        }
    }
}

void MeasuredSurface::addSpreadPoints(std::size_t count)
{
    std::vector<double> areas; // cumulative
    for (const Triangle& t : _triangles)
        areas.push_back((areas.empty() ? 0.0 : areas.back()) +
                        glm::length(glm::cross(at(t, 1) - at(t, 0), at(t, 2) - at(t, 0))));
    std::mt19937_64 random(1);
    const auto next = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    for (std::size_t i = 0; i < count && !areas.empty(); ++i)
    {
        const auto chosen = std::lower_bound(areas.begin(), areas.end() - 1, areas.back() * next());
        const auto number = static_cast<std::uint32_t>(chosen - areas.begin());
        const Triangle& t = _triangles[number];
        double u = next(), v = next();
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        _spreadPoints.push_back(
            {at(t, 0) + u * (at(t, 1) - at(t, 0)) + v * (at(t, 2) - at(t, 0)), number, u, v});
    }
    std::stable_sort(_spreadPoints.begin(), _spreadPoints.end(),
                     [](const SurfacePoint& a, const SurfacePoint& b) { return a.triangle < b.triangle; });
}

} // namespace osgPMObjects::core
