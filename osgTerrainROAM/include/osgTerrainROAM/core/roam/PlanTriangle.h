// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Any triangle whose corners are points of the grid, in plan. GridTriangle is the special and quicker case
/// of the bintree; both have the same functions, so that what visits samples takes either.
/// All tests are in integers: a point on an edge lies in both triangles that share it.
struct PlanTriangle
{
    std::array<GridPoint, 3> corners; ///< counter-clockwise seen from above

    /// Twice the area in cells; 0 or less: the triangle has no extent, or is turned over.
    std::int64_t doubleArea() const { return cross(corners[0], corners[1], corners[2]); }

    /// The rectangle around it.
    GridRect extent() const
    {
        const auto [west, east] = std::minmax({corners[0].column, corners[1].column, corners[2].column});
        const auto [south, north] = std::minmax({corners[0].row, corners[1].row, corners[2].row});
        return {west, south, east, north};
    }

    /// Whether a point lies in it or on its border. Precondition: doubleArea() > 0.
    bool holds(GridPoint p) const
    {
        return cross(corners[0], corners[1], p) >= 0 && cross(corners[1], corners[2], p) >= 0 &&
               cross(corners[2], corners[0], p) >= 0;
    }

    /// Whether more of it than its border lies in a field of `columns` x `rows` samples.
    bool overlaps(int columns, int rows) const
    {
        const GridRect around = extent();
        return around.west < columns - 1 && around.south < rows - 1;
    }

    /// The coordinates of a point: p = c0 + u (c1 - c0) + w (c2 - c0). Precondition: doubleArea() > 0.
    GridTriangle::Barycentric at(int column, int row) const
    {
        const GridPoint p{column, row};
        const auto area = static_cast<double>(doubleArea());
        return {static_cast<double>(cross(p, corners[2], corners[0])) / area,
                static_cast<double>(cross(p, corners[0], corners[1])) / area};
    }

    /// As GridTriangle::forEachRow. Precondition: doubleArea() > 0.
    template<class Visit>
    void forEachRow(int columns, int rows, const Visit& visit, int step = 1) const
    {
        const GridRect around = extent();
        const int north = std::min(around.north, rows - 1);
        for (int row = (around.south + step - 1) & -step; row <= north; row += step)
        {
            int west = std::numeric_limits<int>::max(), east = std::numeric_limits<int>::min();
            for (int i = 0; i < 3; ++i)
                widen(corners[i], corners[(i + 1) % 3], row, west, east);
            west = (west + step - 1) & -step;
            east = std::min(east, columns - 1) & -step;
            if (west <= east) visit(row, west, east);
        }
    }

private:
    static std::int64_t cross(GridPoint a, GridPoint b, GridPoint c)
    {
        return std::int64_t{b.column - a.column} * (c.row - a.row) -
               std::int64_t{b.row - a.row} * (c.column - a.column);
    }

    static int floorOfRatio(std::int64_t above, std::int64_t below)
    {
        const std::int64_t ratio = above / below;
        return static_cast<int>(ratio - (above % below != 0 && (above < 0) != (below < 0) ? 1 : 0));
    }

    /// Widens [west, east] to the columns, rounded inwards, where edge a-b crosses `row`.
    static void widen(GridPoint a, GridPoint b, int row, int& west, int& east)
    {
        if (a.row > b.row) std::swap(a, b);
        if (row < a.row || row > b.row) return;
        if (a.row == b.row)
        {
            west = std::min({west, a.column, b.column});
            east = std::max({east, a.column, b.column});
            return;
        }
        const std::int64_t above = std::int64_t{b.column - a.column} * (row - a.row), below = b.row - a.row;
        west = std::min(west, a.column - floorOfRatio(-above, below));
        east = std::max(east, a.column + floorOfRatio(above, below));
    }
};

} // namespace osgTerrainROAM::core
