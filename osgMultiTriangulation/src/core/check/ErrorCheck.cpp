// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <osgMultiTriangulation/core/check/ErrorCheck.h>

namespace osgMultiTriangulation::core
{

PointCells::PointCells(std::span<const SurfacePoint> points) : _points(points.size())
{
    double high[2] = {0.0, 0.0};
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        const double at[2] = {double(points[i].x), double(points[i].y)};
        for (int axis = 0; axis < 2; ++axis)
        {
            _low[axis] = i == 0 ? at[axis] : std::min(_low[axis], at[axis]);
            high[axis] = i == 0 ? at[axis] : std::max(high[axis], at[axis]);
        }
    }
    const double area = (high[0] - _low[0] + 1.0) * (high[1] - _low[1] + 1.0);
    _cell = std::max(1.0, std::sqrt(2.0 * area / std::max<std::size_t>(points.size(), 1)));
    for (int axis = 0; axis < 2; ++axis)
        _cells[axis] = static_cast<std::uint32_t>((high[axis] - _low[axis]) / _cell) + 1;
    _first.assign(std::size_t(_cells[0]) * _cells[1] + 1, 0);
    const auto cell = [&](const SurfacePoint& p)
    { return std::size_t(cellOf(p.y, 1)) * _cells[0] + cellOf(p.x, 0); };
    for (const SurfacePoint& p : points)
        ++_first[cell(p) + 1];
    for (std::size_t i = 1; i < _first.size(); ++i)
        _first[i] += _first[i - 1];
    std::vector<std::uint32_t> next(_first.begin(), _first.end() - 1);
    for (const SurfacePoint& p : points)
        _points[next[cell(p)]++] = p;
}

std::uint32_t PointCells::cellOf(double coordinate, int axis) const
{
    return static_cast<std::uint32_t>(std::clamp((coordinate - _low[axis]) / _cell, 0.0, _cells[axis] - 1.0));
}

double PointCells::greatestExcess(const SurfaceMesh& mesh, std::span<const float> bounds) const
{
    std::vector<double> excess(_points.size(), std::numeric_limits<double>::infinity());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const SurfacePoint &a = mesh.points[mesh.triangles[t][0]], &b = mesh.points[mesh.triangles[t][1]],
                           &c = mesh.points[mesh.triangles[t][2]];
        const double area = twiceArea(a, b, c);
        const std::uint32_t west = cellOf(std::min({a.x, b.x, c.x}), 0),
                            east = cellOf(std::max({a.x, b.x, c.x}), 0);
        const std::uint32_t south = cellOf(std::min({a.y, b.y, c.y}), 1),
                            north = cellOf(std::max({a.y, b.y, c.y}), 1);
        for (std::uint32_t row = south; row <= north; ++row)
            for (std::uint32_t i = _first[std::size_t(row) * _cells[0] + west];
                 i < _first[std::size_t(row) * _cells[0] + east + 1]; ++i)
            {
                const SurfacePoint& p = _points[i];
                const double onA = twiceArea(b, c, p), onB = twiceArea(c, a, p), onC = twiceArea(a, b, p);
                if (onA < 0.0 || onB < 0.0 || onC < 0.0) continue;
                const double height = (onA * a.height + onB * b.height + onC * c.height) / area;
                excess[i] = std::min(excess[i], std::abs(height - p.height) - bounds[t]);
            }
    }
    return excess.empty() ? 0.0 : *std::ranges::max_element(excess);
}

} // namespace osgMultiTriangulation::core
