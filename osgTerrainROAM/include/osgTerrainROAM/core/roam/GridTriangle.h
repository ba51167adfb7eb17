// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdlib>
#include <limits>

#include <osgTerrainROAM/core/heightfield/GridRect.h>

namespace osgTerrainROAM::core
{

/// A point of the sample grid.
struct GridPoint
{
    int column = 0;
    int row = 0;

    friend bool operator==(const GridPoint&, const GridPoint&) = default;
    friend GridPoint middle(GridPoint a, GridPoint b)
    {
        return {(a.column + b.column) / 2, (a.row + b.row) / 2};
    }
};

/// A bintree triangle in grid indices. Its edges run along axes and diagonals, so it rasterises in integers.
struct GridTriangle
{
    GridPoint apex, left, right;

    /// The sample that splits it. Precondition: the triangle is not of the finest level.
    GridPoint middleOfBase() const { return middle(left, right); }

    /// Whether more of it than its border lies in a field of `columns` × `rows` samples.
    bool overlaps(int columns, int rows) const
    {
        return std::min({apex.column, left.column, right.column}) < columns - 1 &&
               std::min({apex.row, left.row, right.row}) < rows - 1;
    }

    friend bool operator==(const GridTriangle&, const GridTriangle&) = default;

    /// The halves, from the apex to the middle of the base: with the left corner, with the right.
    std::array<GridTriangle, 2> children() const
    {
        const GridPoint mid = middleOfBase();
        return {{{mid, apex, left}, {mid, right, apex}}};
    }

    /// The rectangle around it.
    GridRect extent() const
    {
        const auto [west, east] = std::minmax({apex.column, left.column, right.column});
        const auto [south, north] = std::minmax({apex.row, left.row, right.row});
        return {west, south, east, north};
    }

    /// Whether a point lies in it or on its border.
    bool holds(GridPoint p) const
    {
        const Barycentric b = at(p.column, p.row);
        return b.u >= 0.0 && b.w >= 0.0 && b.u + b.w <= 1.0;
    }

    /// Calls visit(row, west, east) for every row that the triangle touches within `columns` × `rows` points;
    /// the points west…east, borders included, lie in it. Visits only rows and columns that are multiples of
    /// `step`, a power of two.
    template<class Visit>
    void forEachRow(int columns, int rows, const Visit& visit, int step = 1) const
    {
        const int south = (std::min({apex.row, left.row, right.row}) + step - 1) & -step;
        const int north = std::min(std::max({apex.row, left.row, right.row}), rows - 1);
        for (int row = south; row <= north; row += step)
        {
            int west = std::numeric_limits<int>::max(), east = std::numeric_limits<int>::min();
            widen(apex, left, row, west, east);
            widen(left, right, row, west, east);
            widen(right, apex, row, west, east);
            west = (west + step - 1) & -step;
            east = std::min(east, columns - 1) & -step;
            if (west <= east) visit(row, west, east);
        }
    }

    /// The coordinates of a point p of the plane: p = apex + u·(left − apex) + w·(right − apex). The legs are
    /// perpendicular and of one length, so (u, w) are dot products divided by its square: a power of two,
    /// exact in binary.
    struct Barycentric
    {
        double u, w;
    };

    /// The change of (u, w) from one sample to the next eastwards and northwards.
    Barycentric perColumn() const { return scaled(left.column - apex.column, right.column - apex.column); }
    Barycentric perRow() const { return scaled(left.row - apex.row, right.row - apex.row); }

    Barycentric at(int column, int row) const
    {
        const Barycentric east = perColumn(), north = perRow();
        const int c = column - apex.column, r = row - apex.row;
        return {east.u * c + north.u * r, east.w * c + north.w * r};
    }

private:
    Barycentric scaled(int alongLeft, int alongRight) const
    {
        const double lc = left.column - apex.column, lr = left.row - apex.row;
        const double inverse = 1.0 / (lc * lc + lr * lr);
        return {alongLeft * inverse, alongRight * inverse};
    }

    /// Widens [west, east] to the point where edge a–b crosses `row`.
    static void widen(GridPoint a, GridPoint b, int row, int& west, int& east)
    {
        if (row < std::min(a.row, b.row) || row > std::max(a.row, b.row)) return;
        if (a.row == b.row)
        {
            west = std::min({west, a.column, b.column});
            east = std::max({east, a.column, b.column});
            return;
        }
        const int column = a.column + (b.column - a.column) / (b.row - a.row) * (row - a.row);
        west = std::min(west, column);
        east = std::max(east, column);
    }
};

/// The two triangles that cover a tile of side × side samples: their common base is the diagonal from
/// south-west to north-east, and each is the other rotated about its middle.
inline std::array<GridTriangle, 2> rootTriangles(int side)
{
    const int last = side - 1;
    const GridPoint southWest{0, 0}, southEast{last, 0}, northWest{0, last}, northEast{last, last};
    return {{{southEast, northEast, southWest}, {northWest, southWest, northEast}}};
}

} // namespace osgTerrainROAM::core
