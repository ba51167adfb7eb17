// SPDX-License-Identifier: Apache-2.0
#include "terraintool/bench/BenchSquare.h"

#include <algorithm>
#include <cmath>

namespace terraintool
{

using namespace osgTerrainROAM::core;

namespace
{

/// Cells of whole seconds of arc count as squares of 30 m a second, as in the other figures on these terrains.
double nominalCellM(double spacingM)
{
    const double seconds = std::round(spacingM / 30.0);
    return seconds >= 1.0 && std::abs(spacingM - 30.0 * seconds) < 0.04 * spacingM ? 30.0 * seconds
                                                                                   : spacingM;
}

} // namespace

foundation::Result<HeightField> squareOf(const HeightField& all, const SquareChoice& choice,
                                         const std::string& file)
{
    int size = 2;
    while (2 * size < std::min(all.columns, all.rows))
        size *= 2;
    int side = size + 1;
    int column = (all.columns - side) / 2, fromNorth = (all.rows - side) / 2;
    if (!choice.crop.empty()) side = choice.crop[0];
    if (choice.crop.size() == 3)
    {
        column = choice.crop[1];
        fromNorth = choice.crop[2];
    }
    const bool fits = side >= 3 && column >= 0 && fromNorth >= 0 && column + side <= all.columns &&
                      fromNorth + side <= all.rows;
    if (!fits)
        return foundation::Error{file, "the square is no part of the raster, or too small",
                                 "choose at least 3 samples within it"};
    HeightField square;
    square.name = all.name;
    square.columns = square.rows = side;
    square.spacingEastM = square.spacingNorthM = choice.cellM.value_or(nominalCellM(all.spacingNorthM));
    for (int row = all.rows - fromNorth - side; row < all.rows - fromNorth; ++row)
        for (int c = column; c < column + side; ++c)
            square.heightsM.push_back(all.heightM(c, row));
    return square;
}

} // namespace terraintool
