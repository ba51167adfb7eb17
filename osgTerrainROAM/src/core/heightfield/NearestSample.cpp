// SPDX-License-Identifier: Apache-2.0
#include "NearestSample.h"

#include <cmath>

namespace osgTerrainROAM::core
{

NearestSample::NearestSample(std::span<const std::uint8_t> isMarked, int columns, int rows)
    : _columns(columns), _rows(rows), _offsets(isMarked.size(), Offset{kFar, kFar})
{
    for (std::size_t i = 0; i < isMarked.size(); ++i)
        if (isMarked[i]) _offsets[i] = {0, 0};
    for (int row = 0; row < rows; ++row)
        sweep(row, row - 1);
    for (int row = rows - 1; row >= 0; --row)
        sweep(row, row + 1);
}

/// Propagates offsets from a neighbouring row, and then along the row in both directions.
void NearestSample::sweep(int row, int fromRow)
{
    if (fromRow >= 0 && fromRow < _rows)
        for (int column = 0; column < _columns; ++column)
            for (int from = column - 1; from <= column + 1; ++from)
                take(column, row, from, fromRow);
    for (int column = 1; column < _columns; ++column)
        take(column, row, column - 1, row);
    for (int column = _columns - 2; column >= 0; --column)
        take(column, row, column + 1, row);
}

void NearestSample::take(int column, int row, int fromColumn, int fromRow)
{
    if (fromColumn < 0 || fromColumn >= _columns) return;
    const Offset theirs = _offsets[index(fromColumn, fromRow)];
    if (theirs.columns == kFar) return;
    const int columns = theirs.columns + fromColumn - column, rows = theirs.rows + fromRow - row;
    Offset& mine = _offsets[index(column, row)];
    const auto square = [](std::int64_t c, std::int64_t r) { return c * c + r * r; };
    if (mine.columns == kFar || square(columns, rows) < square(mine.columns, mine.rows))
        mine = {static_cast<std::int16_t>(columns), static_cast<std::int16_t>(rows)};
}

std::size_t NearestSample::nearest(int column, int row) const
{
    const Offset offset = _offsets[index(column, row)];
    return offset.columns == kFar ? index(column, row) : index(column + offset.columns, row + offset.rows);
}

double NearestSample::distance(int column, int row) const
{
    const Offset offset = _offsets[index(column, row)];
    return std::hypot(static_cast<double>(offset.columns), static_cast<double>(offset.rows));
}

} // namespace osgTerrainROAM::core
