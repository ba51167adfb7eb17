// SPDX-License-Identifier: Apache-2.0
// Regular decimation of a block: which triangles a level has, and how they meet a coarser border.
// Source: *Methods of continuous level of detail for terrain* (Graphicon 2002), section 3.2 (levels, fans at
// the border); de Boer,
// *Fast terrain rendering using geometrical mipmapping*, 2000. Differs: the diagonals alternate, so that
// levels nest.
#include <osgTerrainROAM/core/blocks/BlockTriangles.h>

namespace osgTerrainROAM::core
{

namespace
{

/// Turns the block so that a point of the south side comes to lie on another side.
GridPoint turned(GridPoint p, int side, int last)
{
    switch (side)
    {
    case south:
        return p;
    case east:
        return {last - p.row, p.column};
    case north:
        return {last - p.column, last - p.row};
    default:
        return {p.row, last - p.column};
    }
}

/// Collects the triangles of the strip along the south side, and turns them.
struct Strip
{
    int step, last, side;
    std::vector<BlockTriangle> triangles;

    void add(GridPoint a, GridPoint b, GridPoint c)
    {
        triangles.push_back({turned(a, side, last), turned(b, side, last), turned(c, side, last)});
    }

    /// The vertex next to the border, or nothing beyond the strip's ends.
    bool hasInner(int column) const { return column >= step && column <= last - step; }

    /// A fan around a vertex of the border from one inner vertex to another.
    void fan(int centre, int from, int to)
    {
        for (int column = from; column < to; column += step)
            if (hasInner(column) && hasInner(column + step))
                add({centre, 0}, {column + step, step}, {column, step});
    }
};

} // namespace

std::vector<BlockTriangle> innerTriangles(int exponent, int level, GridPoint origin)
{
    const int last = 1 << exponent, step = 1 << level;
    std::vector<BlockTriangle> triangles;
    const auto square = [&](int column, int row, int size)
    {
        const GridPoint sw{column, row}, se{column + size, row}, ne{column + size, row + size},
            nw{column, row + size};
        const bool rises = ((origin.column + column) / size + (origin.row + row) / size) % 2 == 0;
        if (rises)
            triangles.insert(triangles.end(), {{se, ne, sw}, {nw, sw, ne}});
        else
            triangles.insert(triangles.end(), {{sw, se, nw}, {ne, nw, se}});
    };
    if (level == exponent)
        square(0, 0, last);
    else
        for (int row = step; row < last - step; row += step)
            for (int column = step; column < last - step; column += step)
                square(column, row, step);
    return triangles;
}

std::vector<BlockTriangle> borderTriangles(int exponent, int level, int side, int border)
{
    const int last = 1 << exponent, step = 1 << level, apart = 1 << border;
    Strip strip{step, last, side, {}};
    if (border == level)
    {
        for (int column = step; column < last; column += 2 * step)
        {
            const GridPoint middle{column, step};
            strip.add({column - step, 0}, {column, 0}, middle);
            strip.add({column, 0}, {column + step, 0}, middle);
            strip.fan(column - step, column - step, column);
            strip.fan(column + step, column, column + step);
        }
        return strip.triangles;
    }
    for (int column = 0; column < last; column += apart)
    {
        const int middle = column + apart / 2;
        strip.fan(column, column, middle);
        strip.add({column, 0}, {column + apart, 0}, {middle, step});
        strip.fan(column + apart, middle, column + apart);
    }
    return strip.triangles;
}

std::vector<BlockTriangle> trianglesOf(int exponent, const BlockShape& shape, GridPoint origin)
{
    std::vector<BlockTriangle> triangles = innerTriangles(exponent, shape.level, origin);
    for (int side = 0; side < kSides && shape.level < exponent; ++side)
    {
        const auto strip = borderTriangles(exponent, shape.level, side, shape.borders[side]);
        triangles.insert(triangles.end(), strip.begin(), strip.end());
    }
    return triangles;
}

std::uint32_t triangleCount(int exponent, const BlockShape& shape)
{
    if (shape.level == exponent) return 2;
    const std::uint32_t squares = 1u << (exponent - shape.level);
    std::uint32_t count = 2 * (squares - 2) * (squares - 2);
    for (const int border : shape.borders)
        count += squares - 2 + (1u << (exponent - border));
    return count;
}

} // namespace osgTerrainROAM::core
