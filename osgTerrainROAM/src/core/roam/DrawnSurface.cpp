// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/heightfield/VerticalHit.h>
#include <osgTerrainROAM/core/roam/DrawnSurface.h>

#include "MovedTriangle.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kCellsOfSquare = 16.0;

std::array<glm::dvec3, 3> cornersOf(const DrawnMesh& mesh, std::uint32_t triangle)
{
    const auto& v = mesh.triangles[triangle].vertices;
    return {mesh.position(v[0]), mesh.position(v[1]), mesh.position(v[2])};
}

} // namespace

DrawnSurface::DrawnSurface(const PlacedTile& tile, DrawnMesh mesh) : _tile(tile), _mesh(std::move(mesh))
{
    _squareM = kCellsOfSquare * glm::dvec2(tile.field().spacingEastM, tile.field().spacingNorthM);
    glm::dvec2 low(1e300), high(-1e300);
    for (const LeafTriangle& t : _mesh.triangles)
        for (const std::uint32_t v : t.vertices)
        {
            low = glm::min(low, glm::dvec2(_mesh.position(v)));
            high = glm::max(high, glm::dvec2(_mesh.position(v)));
        }
    if (_mesh.triangles.empty()) return;
    _corner = low;
    _columns = static_cast<int>((high.x - low.x) / _squareM.x) + 1;
    _rows = static_cast<int>((high.y - low.y) / _squareM.y) + 1;
    _squares.resize(static_cast<std::size_t>(_columns) * static_cast<std::size_t>(_rows));
    for (std::uint32_t i = 0; i < _mesh.triangles.size(); ++i)
    {
        const auto p = cornersOf(_mesh, i);
        const auto [west, east] = std::minmax({p[0].x, p[1].x, p[2].x});
        const auto [south, north] = std::minmax({p[0].y, p[1].y, p[2].y});
        for (int r = row(south); r <= row(north); ++r)
            for (int c = column(west); c <= column(east); ++c)
                _squares[static_cast<std::size_t>(r * _columns + c)].push_back(i);
    }
}

int DrawnSurface::column(double eastM) const
{
    return std::clamp(static_cast<int>((eastM - _corner.x) / _squareM.x), 0, _columns - 1);
}

int DrawnSurface::row(double northM) const
{
    return std::clamp(static_cast<int>((northM - _corner.y) / _squareM.y), 0, _rows - 1);
}

std::optional<DrawnSurface::Found> DrawnSurface::uppermost(const glm::dvec2& place) const
{
    if (_squares.empty() || !std::isfinite(place.x) || !std::isfinite(place.y)) return std::nullopt;
    const glm::dvec2 high = _corner + _squareM * glm::dvec2(_columns, _rows);
    if (place.x < _corner.x || place.y < _corner.y || place.x > high.x || place.y > high.y)
        return std::nullopt;
    std::optional<Found> found;
    for (const std::uint32_t i :
         _squares[static_cast<std::size_t>(row(place.y) * _columns + column(place.x))])
    {
        const VerticalHit hit = verticalHit(cornersOf(_mesh, i), {}, place);
        if (!hit.isInside()) continue; // nor one without extent, whose weights are no numbers
        if (!found || hit.position.z > found->position.z) found = Found{i, hit.position, hit.normal};
    }
    return found;
}

/// Of overlapping parts, samples that another part lies above do not count.
double DrawnSurface::boundM(std::uint32_t triangle) const
{
    const auto p = cornersOf(_mesh, triangle);
    MovedTriangle plan;
    for (std::size_t i = 0; i < 3; ++i)
    {
        const GridPoint own = _mesh.grid[_mesh.triangles[triangle].vertices[i]];
        plan.corners[i] = _mesh.isMorphed ? _tile.frame().gridAt(p[i]) : glm::dvec2(own.column, own.row);
    }
    double largestM = 0.0;
    if (plan.doubleArea() <= MovedTriangle::kRounding) return largestM;
    plan.forEachSample(_tile,
                       [&](int column, int row, double u, double w)
                       {
                           const glm::dvec3 drawn = p[0] + (p[1] - p[0]) * u + (p[2] - p[0]) * w;
                           if (_mesh.overlaps())
                               if (const auto upper = uppermost(drawn);
                                   upper && upper->position.z > drawn.z + _mesh.stepM)
                                   return;
                           largestM = std::max(largestM, glm::distance(drawn, _tile.position(column, row)));
                       });
    return largestM;
}

std::optional<DrawnSurface::Ground> DrawnSurface::at(double eastM, double northM) const
{
    const auto found = uppermost({eastM, northM});
    if (!found) return std::nullopt;
    return Ground{found->position, found->normal, boundM(found->triangle), _mesh.triangles[found->triangle]};
}

} // namespace osgTerrainROAM::core
