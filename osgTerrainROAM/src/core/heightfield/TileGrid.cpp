// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cassert>

#include <osgTerrainROAM/core/heightfield/TileGrid.h>

namespace osgTerrainROAM::core
{

TileGrid::TileGrid(const HeightField& field, int exponent)
    : _exponent(exponent),
      _betweenSamples((1 << exponent) - 1),
      _side(((field.tileSide() - 1) << exponent) + 1),
      _levels(2 * (std::bit_width(static_cast<unsigned>(_side - 1)) - 1)),
      _dataColumns(((field.columns - 1) << exponent) + 1),
      _dataRows(((field.rows - 1) << exponent) + 1),
      _samplesPerRow(static_cast<std::size_t>(field.columns))
{
    assert(exponent >= 0 && _side <= kMostSide);
}

} // namespace osgTerrainROAM::core
