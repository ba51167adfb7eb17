// SPDX-License-Identifier: Apache-2.0
#include "SquareTile.h"

#include <algorithm>
#include <cmath>

#include <osgTerrainROAM/core/heightfield/DemImport.h>

namespace framebench
{

using namespace osgTerrainROAM::core;

namespace
{

/// Returns the side of a cell. One second of arc counts as 30 m in both directions, as in the other measurements of these
/// terrains.
double nominalCellM(double spacingM)
{
    const double seconds = std::round(spacingM / 30.0);
    return seconds >= 1.0 && std::abs(spacingM - 30.0 * seconds) < 0.04 * spacingM ? 30.0 * seconds
                                                                                   : spacingM;
}

int largestSide(const HeightField& field)
{
    int cells = 2;
    while (2 * cells < std::min(field.columns, field.rows))
        cells *= 2;
    return cells + 1;
}

bool isTileSide(int side)
{
    const int cells = side - 1;
    return cells >= 2 && (cells & (cells - 1)) == 0;
}

} // namespace

foundation::Result<std::shared_ptr<const RoamTile>> squareTile(const std::filesystem::path& file,
                                                               const std::vector<int>& crop)
{
    const auto all = importDem(file);
    if (!all) return all.error();
    const int side = crop.empty() ? largestSide(*all) : crop[0];
    const int column = crop.size() == 3 ? crop[1] : (all->columns - side) / 2;
    const int fromNorth = crop.size() == 3 ? crop[2] : (all->rows - side) / 2;
    const bool fits = isTileSide(side) && column >= 0 && fromNorth >= 0 && column + side <= all->columns &&
                      fromNorth + side <= all->rows;
    if (!fits)
        return foundation::Error{file.string(),
                                 "the square is no part of the raster, or has not 2^n+1 samples",
                                 "choose another one"};
    HeightField square;
    square.name = all->name;
    square.columns = square.rows = side;
    square.spacingEastM = square.spacingNorthM = nominalCellM(all->spacingNorthM);
    for (int row = all->rows - fromNorth - side; row < all->rows - fromNorth; ++row)
        for (int c = column; c < column + side; ++c)
            square.heightsM.push_back(all->heightM(c, row));
    return std::make_shared<const RoamTile>(PlacedTile(std::move(square), Placement::planar));
}

} // namespace framebench
