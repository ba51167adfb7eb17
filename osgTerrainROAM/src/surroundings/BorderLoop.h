// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <glm/glm.hpp>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

#include "../material/MapGrid.h"

namespace osgTerrainROAM
{

/// The raster samples along the border of the data, as a closed loop: south, east, north, west. It gives
/// means over stretches of the border.
/// Units: a position on the loop is a number of samples, 0 … length(); metres. Threads: immutable.
class BorderLoop
{
public:
    /// `isWater(x, y)`: tells whether the texel of a map is water.
    template<class IsWater>
    BorderLoop(const core::PlacedTile& tile, const MapGrid& map, const IsWater& isWater)
        : _columns(tile.field().columns - 1), _rows(tile.field().rows - 1)
    {
        for (int i = 0; i < length(); ++i)
        {
            const glm::ivec2 sample = sampleAt(i);
            const glm::ivec2 point = sample * tile.grid().cellSide();
            const glm::ivec2 texel = glm::min(point / map.step, glm::ivec2(map.width - 1, map.height - 1));
            add(tile.samples().heightM(point.x, point.y), isWater(texel.x, texel.y));
        }
        close();
    }

    int length() const { return 2 * (_columns + _rows); }

    /// Returns the sample (column, row) at a position, 0 ≤ i < length().
    glm::ivec2 sampleAt(int i) const;

    /// Returns the position of a point of the border, in samples.
    double positionOf(const glm::dvec2& sample) const;

    struct Means
    {
        double heightM;
        double water;        ///< share, 0…1
        double waterHeightM; ///< of the water alone; where there is none, `heightM`
    };
    /// Returns the means over `halfWidth` samples to either side of a position.
    Means around(double position, double halfWidth) const;

private:
    using Sums = glm::dvec3; ///< of height, water, height · water

    void add(double heightM, bool water);
    void close();
    Sums integral(double position) const;

    int _columns, _rows;
    std::vector<Sums> _values;    ///< by sample; the first once more at the end
    std::vector<Sums> _integrals; ///< from the start to each sample
};

} // namespace osgTerrainROAM
