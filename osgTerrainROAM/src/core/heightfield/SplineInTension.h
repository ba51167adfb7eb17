// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTerrainROAM::core
{

/// An unknown sample, and the range to which it is limited.
struct VoidCell
{
    int column, row;
    float lowM, highM; ///< range of the rim of its void
};

/// One level of the multiresolution solution. Coarse levels give finer ones their initial values.
struct VoidLevel
{
    int columns, rows;
    double samplesPerCell;
    std::vector<float> heightsM;      ///< complete once filled
    std::vector<std::uint8_t> isVoid; ///< 1: unknown, may change
    std::vector<VoidCell> voids;

    std::size_t index(int column, int row) const { return static_cast<std::size_t>(row) * columns + column; }
    bool contains(int column, int row) const
    {
        return column >= 0 && column < columns && row >= 0 && row < rows;
    }
};

/// Relaxes the voids to the surface of least bending and tension through the known samples: it minimises the
/// sum, over all cells, of squared second differences and, weighted by 1/(12 samples)², of squared first
/// differences.
/// Source: Smith & Wessel, *Gridding with Continuous Curvature Splines in Tension*, 1990. Differs: the energy
/// is minimised directly, by successive over-relaxation projected onto the cells' ranges; the tension is
/// given as a length, not as a factor.
/// Cost: about 10 ns per void and sweep, at most 200 sweeps.
void relaxSpline(VoidLevel& level);

} // namespace osgTerrainROAM::core
