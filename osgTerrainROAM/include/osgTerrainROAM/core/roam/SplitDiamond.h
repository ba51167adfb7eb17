// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include <osgTerrainROAM/core/roam/GridTriangle.h>

namespace osgTerrainROAM::core
{

/// The diamond of a vertex that splits triangles of a bintree, computed from its position in the grid.
/// A vertex lies in the middle of a square of side 2h, or in the middle of an edge of one; h is the lowest
/// bit of its coordinates. Bases of squares join the corners whose column and row, counted in squares, have
/// an even sum.
class SplitDiamond
{
public:
    /// `v`: not a corner of the tile. `side`: of the grid, 2^N+1 points.
    SplitDiamond(GridPoint v, int side) : _v(v), _side(side)
    {
        const int bits = v.column | v.row;
        _half = bits & -bits;
        _isCentre = ((v.column & v.row) & _half) != 0;
        if (_isCentre)
        {
            const int corner =
                ((v.column - _half) / (2 * _half) + (v.row - _half) / (2 * _half)) % 2 == 0 ? 1 : -1;
            _alongBase = {_half, corner * _half};
            _towardsApex = {_half, -corner * _half};
        }
        else
        {
            const bool isAcross = (v.column & _half) != 0;
            _alongBase = isAcross ? GridPoint{_half, 0} : GridPoint{0, _half};
            _towardsApex = isAcross ? GridPoint{0, _half} : GridPoint{_half, 0};
        }
    }

    GridPoint vertex() const { return _v; }
    int half() const { return _half; }
    bool isCentre() const { return _isCentre; }

    /// The level of the triangles that it splits: 0 for the roots.
    int level() const
    {
        const int squares = std::bit_width(static_cast<unsigned>((_side - 1) / _half)) - 2;
        return 2 * squares + (_isCentre ? 0 : 1);
    }

    std::array<GridPoint, 2> baseEnds() const { return {plus(_alongBase, 1), plus(_alongBase, -1)}; }

    /// Visits the triangles that it splits, apex first, counter-clockwise: two, or one where it lies on the
    /// tile's border.
    template<class Visit>
    void forEachTriangle(const Visit& visit) const
    {
        const auto [first, second] = baseEnds();
        for (const int sign : {1, -1})
        {
            const GridPoint apex = plus(_towardsApex, sign);
            if (!isInTile(apex)) continue;
            const auto turn = std::int64_t{first.column - apex.column} * (second.row - apex.row) -
                              std::int64_t{first.row - apex.row} * (second.column - apex.column);
            visit(turn > 0 ? GridTriangle{apex, first, second} : GridTriangle{apex, second, first});
        }
    }

    /// Visits the vertices one level coarser that have to be split before: the apexes, unless they are the
    /// tile's corners.
    template<class Visit>
    void forEachParent(const Visit& visit) const
    {
        for (const int sign : {1, -1})
            if (const GridPoint p = plus(_towardsApex, sign); isInTile(p) && !isCorner(p)) visit(p);
    }

    /// Visits the vertices in the middle of its legs, one level finer.
    template<class Visit>
    void forEachChild(const Visit& visit) const
    {
        if (!_isCentre && _half == 1) return;
        const int way = _isCentre ? _half : _half / 2;
        static constexpr GridPoint kAxes[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
        static constexpr GridPoint kDiagonals[4] = {{1, 1}, {-1, 1}, {1, -1}, {-1, -1}};
        for (const GridPoint& d : _isCentre ? kAxes : kDiagonals)
            if (const GridPoint c{_v.column + way * d.column, _v.row + way * d.row}; isInTile(c)) visit(c);
    }

    /// The rectangle around its triangles.
    GridRect extent() const { return GridRect{_v.column, _v.row, _v.column, _v.row}.grownBy(_half); }

private:
    GridPoint plus(GridPoint offset, int sign) const
    {
        return {_v.column + sign * offset.column, _v.row + sign * offset.row};
    }
    bool isInTile(GridPoint p) const
    {
        return p.column >= 0 && p.row >= 0 && p.column < _side && p.row < _side;
    }
    bool isCorner(GridPoint p) const
    {
        return (p.column == 0 || p.column == _side - 1) && (p.row == 0 || p.row == _side - 1);
    }

    GridPoint _v;
    int _side;
    int _half = 0;
    bool _isCentre = false;
    GridPoint _alongBase, _towardsApex;
};

} // namespace osgTerrainROAM::core
