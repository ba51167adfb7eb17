// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace osgTerrainROAM::core
{

/// A view of a tile's raster alone: columns and rows are those of its samples, however fine the tile's grid
/// is.
class SampleRaster
{
public:
    explicit SampleRaster(const PlacedTile& tile) : _tile(&tile) {}

    int side() const { return ((_tile->grid().side() - 1) >> shift()) + 1; } ///< of the padded tile, 2^n+1
    int levels() const { return _tile->grid().levels() - 2 * shift(); }
    int dataColumns() const { return _tile->field().columns; }
    int dataRows() const { return _tile->field().rows; }
    float heightM(int column, int row) const
    {
        return _tile->samples().heightM(column << shift(), row << shift());
    }
    glm::dvec3 position(int column, int row) const
    {
        return _tile->position(column << shift(), row << shift());
    }
    /// Position between samples.
    glm::dvec3 positionAt(double column, double row, double heightM) const
    {
        const double step = 1 << shift();
        return _tile->frame().positionAt(column * step, row * step, heightM);
    }
    const SampleTable& table() const { return _tile->samples().table(); }
    const PlacedTile& tile() const { return *_tile; }

private:
    int shift() const { return _tile->grid().exponent(); }

    const PlacedTile* _tile;
};

} // namespace osgTerrainROAM::core
