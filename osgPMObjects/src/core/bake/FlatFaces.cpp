// SPDX-License-Identifier: Apache-2.0
#include "FlatFaces.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace osgPMObjects::core
{

namespace
{

/// Overlap of two touching triangles by rounding, as a share of the box.
constexpr double kTouching = 1e-9;
constexpr double kMostSide = 256.0;

/// Whether all of `b` is outside of one side of `a`.
bool isOutside(const FlatTriangle& a, const FlatTriangle& b, double tolerance)
{
    for (std::size_t i = 0; i < 3; ++i)
    {
        const glm::dvec2 &from = a[i], to = a[(i + 1) % 3];
        const double reach = tolerance * glm::length(to - from);
        if (std::all_of(b.begin(), b.end(),
                        [&](const glm::dvec2& p) { return doubleArea(from, to, p) <= reach; }))
            return true;
    }
    return false;
}

} // namespace

bool overlap(const FlatTriangle& a, const FlatTriangle& b, double tolerance)
{
    return !isOutside(a, b, tolerance) && !isOutside(b, a, tolerance);
}

FlatFaces::FlatFaces(const glm::dvec2& low, const glm::dvec2& high, std::size_t expected)
    : _low(low),
      _tolerance(kTouching * glm::length(high - low)),
      _side(static_cast<int>(std::clamp(std::sqrt(static_cast<double>(expected)), 1.0, kMostSide))),
      _cells(static_cast<std::size_t>(_side) * static_cast<std::size_t>(_side))
{
    _cellsPerUnit = static_cast<double>(_side) / glm::max(high - low, glm::dvec2(1e-300));
}

FlatFaces::Cells FlatFaces::cellsOf(const FlatTriangle& t) const
{
    const glm::dvec2 low = (glm::min(glm::min(t[0], t[1]), t[2]) - _low) * _cellsPerUnit;
    const glm::dvec2 high = (glm::max(glm::max(t[0], t[1]), t[2]) - _low) * _cellsPerUnit;
    const auto cell = [&](double x) { return static_cast<int>(std::clamp(x, 0.0, _side - 1.0)); };
    return {cell(low.x), cell(high.x), cell(low.y), cell(high.y)};
}

bool FlatFaces::isFree(const FlatTriangle& triangle, const Cells& cells) const
{
    for (int y = cells.bottom; y <= cells.top; ++y)
        for (int x = cells.left; x <= cells.right; ++x)
            for (const std::uint32_t other : _cells[static_cast<std::size_t>(y * _side + x)])
                if (overlap(triangle, _triangles[other], _tolerance)) return false;
    return true;
}

bool FlatFaces::add(const FlatTriangle& triangle)
{
    const double area = doubleArea(triangle[0], triangle[1], triangle[2]);
    if (area < -_tolerance * _tolerance) return false;
    if (area <= _tolerance * _tolerance) return true; // a line overlaps nothing
    const Cells cells = cellsOf(triangle);
    if (!isFree(triangle, cells)) return false;
    const auto number = static_cast<std::uint32_t>(_triangles.size());
    _triangles.push_back(triangle);
    for (int y = cells.bottom; y <= cells.top; ++y)
        for (int x = cells.left; x <= cells.right; ++x)
            _cells[static_cast<std::size_t>(y * _side + x)].push_back(number);
    return true;
}

} // namespace osgPMObjects::core
