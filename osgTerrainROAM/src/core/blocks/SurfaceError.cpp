// SPDX-License-Identifier: Apache-2.0
#include "SurfaceError.h"

#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/roam/TriangleSamples.h>

namespace osgTerrainROAM::core
{

SurfaceError::SurfaceError(const PlacedTile& tile, const GridRect& around)
    : _tile(tile), _around(around.cutTo(tile.grid().dataRect())), _step(tile.grid().cellSide())
{
    _around.west = (_around.west + _step - 1) & -_step;
    _around.south = (_around.south + _step - 1) & -_step;
    _perRow = (_around.east - _around.west) / _step + 1;
    for (int row = _around.south; row <= _around.north; row += _step)
        for (int column = _around.west; column <= _around.east; column += _step)
            _positions.push_back(tile.position(column, row));
}

double SurfaceError::largestM(const PlanTriangle& triangle, const std::array<glm::dvec3, 3>& corners) const
{
    double largest2 = 0.0;
    const glm::dvec3 du = corners[1] - corners[0], dw = corners[2] - corners[0];
    const auto compare = [&](int column, int row, const glm::dvec3& sample)
    {
        const auto b = triangle.at(column, row);
        const glm::dvec3 off = sample - (corners[0] + du * b.u + dw * b.w);
        largest2 = std::max(largest2, glm::dot(off, off));
    };
    triangle.forEachRow(
        _around.east + 1, _around.north + 1,
        [&](int row, int west, int east)
        {
            if (row < _around.south) return;
            const glm::dvec3* ofRow = &_positions[static_cast<std::size_t>((row - _around.south) / _step) *
                                                  static_cast<std::size_t>(_perRow)];
            for (int column = std::max(west, _around.west); column <= east; column += _step)
                compare(column, row, ofRow[(column - _around.west) / _step]);
        },
        _step);
    const TileSamples& samples = _tile.samples();
    forEachSheetSampleIn(_tile, triangle,
                         [&](GridPoint p) { compare(p.column, p.row, _tile.position(p.column, p.row)); });
    if (!samples.fineSamples().isEmpty())
        samples.fineSamples().forEachIn(triangle.extent(),
                                        [&](int column, int row)
                                        {
                                            if (triangle.holds({column, row}))
                                                compare(column, row, _tile.position(column, row));
                                        });
    return std::sqrt(largest2);
}

} // namespace osgTerrainROAM::core
