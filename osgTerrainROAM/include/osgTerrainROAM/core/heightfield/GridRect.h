// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace osgTerrainROAM::core
{

/// A rectangle of grid points, its borders included; empty when east < west or north < south.
struct GridRect
{
    int west = 0, south = 0, east = -1, north = -1;

    bool isEmpty() const { return east < west || north < south; }
    bool holds(int column, int row) const
    {
        return column >= west && column <= east && row >= south && row <= north;
    }
    GridRect grownBy(int places) const
    {
        return {west - places, south - places, east + places, north + places};
    }
    GridRect cutTo(const GridRect& o) const
    {
        return {std::max(west, o.west), std::max(south, o.south), std::min(east, o.east),
                std::min(north, o.north)};
    }
    /// Calls visit(column, row) for the points whose coordinates are multiples of `step`, a power of two; row
    /// by row.
    template<class Visit>
    void forEachMultipleOf(int step, const Visit& visit) const
    {
        for (int row = (south + step - 1) & -step; row <= north; row += step)
            for (int column = (west + step - 1) & -step; column <= east; column += step)
                visit(column, row);
    }

    friend bool operator==(const GridRect&, const GridRect&) = default;
};

} // namespace osgTerrainROAM::core
