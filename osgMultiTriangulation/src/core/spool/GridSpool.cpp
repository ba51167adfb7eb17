// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <utility>

#include <osgMultiTriangulation/core/spool/GridSpool.h>

namespace osgMultiTriangulation::core
{

GridSpool::GridSpool(SurfaceSpool& spool, int columns, const CellCut& cut)
    : _spool(spool),
      _cut(cut),
      _columns(columns),
      _isUsed(static_cast<std::size_t>(columns), false),
      _isUsedAbove(_isUsed),
      _numbersBelow(_isUsed.size(), kNone),
      _numbers(_isUsed.size(), kNone)
{
}

void GridSpool::addRow(std::span<const float> heights)
{
    for (const float h : heights)
        if (!std::isfinite(h)) ++_holes;
    if (_row > 0)
    {
        cutCells(heights);
        numberRow();
    }
    _heights.assign(heights.begin(), heights.end());
    ++_row;
}

void GridSpool::finish()
{
    if (_row > 0) numberRow();
}

/// Finds the triangles between the last row and the next.
void GridSpool::cutCells(std::span<const float> upper)
{
    for (int c = 0; c + 1 < _columns; ++c)
    {
        const float sw = _heights[c], se = _heights[c + 1], nw = upper[c], ne = upper[c + 1];
        const bool cutsOff = !std::isfinite(se) || !std::isfinite(nw); // then the others are on a rising cut
        const bool rises =
            std::isfinite(sw) && std::isfinite(ne) && (cutsOff || isCutRising(sw, se, nw, ne, _cut));
        const Corner atSw{c, false}, atSe{c + 1, false}, atNw{c, true}, atNe{c + 1, true};
        for (const Cell& cell : {rises ? Cell{atSw, atSe, atNe} : Cell{atSw, atSe, atNw},
                                 rises ? Cell{atSw, atNe, atNw} : Cell{atSe, atNe, atNw}})
        {
            bool isThere = true;
            for (const Corner& corner : cell)
                isThere =
                    isThere && std::isfinite(corner.isUpper ? upper[corner.column] : _heights[corner.column]);
            if (!isThere) continue;
            _cells.push_back(cell);
            for (const Corner& corner : cell)
                (corner.isUpper ? _isUsedAbove : _isUsed)[corner.column] = true;
        }
    }
}

/// Gives numbers to the points of the last row, all of whose triangles are known, and adds the triangles
/// below it.
void GridSpool::numberRow()
{
    for (int c = 0; c < _columns; ++c)
    {
        if (!_isUsed[c]) continue;
        _numbers[c] = _points++;
        _spool.addPoint({c, _row - 1, _heights[c]});
    }
    for (const Cell& cell : _waiting)
    {
        Triangle triangle;
        for (int i = 0; i < 3; ++i)
            triangle[i] = (cell[i].isUpper ? _numbers : _numbersBelow)[cell[i].column];
        _spool.addTriangle(triangle);
    }
    _waiting = std::exchange(_cells, {});
    std::swap(_numbersBelow, _numbers);
    _isUsed.swap(_isUsedAbove);
    _isUsedAbove.assign(_isUsedAbove.size(), false);
}

} // namespace osgMultiTriangulation::core
