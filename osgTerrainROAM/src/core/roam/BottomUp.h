// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// Calls visit(v, children[], count) for every vertex that splits triangles of a bintree over side × side
/// samples, deepest level first. Children: the vertices in the middle of the legs of its diamond, as far as
/// they are in the tile.
template<class Visit>
void forEachDiamondBottomUp(int side, const Visit& visit)
{
    GridPoint children[4];
    const auto gather = [&](GridPoint v, int step, bool diagonal)
    {
        static constexpr int kAxis[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
        static constexpr int kDiagonal[4][2] = {{-1, -1}, {1, -1}, {-1, 1}, {1, 1}};
        int count = 0;
        for (const auto& offset : diagonal ? kDiagonal : kAxis)
        {
            const GridPoint c{v.column + offset[0] * step, v.row + offset[1] * step};
            if (c.column >= 0 && c.row >= 0 && c.column < side && c.row < side) children[count++] = c;
        }
        visit(v, children, count);
    };
    for (int half = 1; half < side; half *= 2)
    {
        // Middles of the edges of squares of side 2·half; their children are centres of squares of side half.
        for (int row = 0; row < side; row += half)
            for (int column = (row / half) % 2 ? 0 : half; column < side; column += 2 * half)
                if (half > 1)
                    gather({column, row}, half / 2, true);
                else
                    visit(GridPoint{column, row}, children, 0);
        // Centres of those squares; their children are the edge middles.
        for (int row = half; row < side; row += 2 * half)
            for (int column = half; column < side; column += 2 * half)
                gather({column, row}, half, false);
    }
}

} // namespace osgTerrainROAM::core
