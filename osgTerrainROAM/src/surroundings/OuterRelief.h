// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace osgTerrainROAM
{

/// The hills of the data, less the mean of their surroundings, on a coarse grid; each level after the first
/// has half as many cells, of their means. Beyond the data the grid of the surroundings gets coarser outwards
/// only: relief that is finer than its cells would be seen as streaks and rows that run straight away from
/// the border.
/// Units: metres; places as shares of the data, 0…1. Threads: immutable.
/// Source: Williams, *Pyramidal parametrics* (1983); between levels linear.
class OuterRelief
{
public:
    OuterRelief() = default;
    /// `heights`: columns · rows, row by row.
    OuterRelief(int columns, int rows, const std::vector<float>& heights);

    /// The relief at a place, of cells that are `coarseness` times as wide as those of the grid, 1 or more.
    double at(double x, double y, double coarseness) const;
    double deviationM() const { return _deviationM; } ///< standard deviation of the finest level

private:
    struct Level
    {
        int columns = 0, rows = 0;
        std::vector<float> values;

        double at(double x, double y) const;
        Level half() const;
    };

    std::vector<Level> _levels;
    double _deviationM = 0.0;
};

} // namespace osgTerrainROAM
