// SPDX-License-Identifier: Apache-2.0
#include "OuterRelief.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM
{

namespace
{

constexpr int kMeanCells = 12; ///< half width, in cells, of the mean that the relief is counted from

/// Subtracts from each value the mean of the square around it.
std::vector<float> lessLocalMean(const std::vector<float>& heights, int columns, int rows)
{
    const auto width = static_cast<std::size_t>(columns) + 1;
    std::vector<double> sums(width * (static_cast<std::size_t>(rows) + 1), 0.0);
    const auto sum = [&](int x, int y) -> double& { return sums[static_cast<std::size_t>(y) * width + x]; };
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * columns + x; };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            sum(x + 1, y + 1) = heights[at(x, y)] + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
    std::vector<float> less(heights.size());
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
        {
            const int west = std::max(x - kMeanCells, 0), east = std::min(x + kMeanCells + 1, columns);
            const int south = std::max(y - kMeanCells, 0), north = std::min(y + kMeanCells + 1, rows);
            const double mean = (sum(east, north) - sum(west, north) - sum(east, south) + sum(west, south)) /
                                ((east - west) * (north - south));
            less[at(x, y)] = heights[at(x, y)] - static_cast<float>(mean);
        }
    return less;
}

} // namespace

OuterRelief::OuterRelief(int columns, int rows, const std::vector<float>& heights)
{
    _levels.push_back({columns, rows, lessLocalMean(heights, columns, rows)});
    double squares = 0.0;
    for (const float value : _levels.front().values)
        squares += static_cast<double>(value) * value;
    _deviationM = std::sqrt(squares / static_cast<double>(heights.size()));
    while (_levels.back().columns > 2 || _levels.back().rows > 2)
        _levels.push_back(_levels.back().half());
}

double OuterRelief::at(double x, double y, double coarseness) const
{
    const double level = std::clamp(std::log2(coarseness), 0.0, static_cast<double>(_levels.size() - 1));
    const auto fine = static_cast<std::size_t>(level);
    const double detailed = _levels[fine].at(x, y);
    if (fine + 1 >= _levels.size()) return detailed;
    return std::lerp(detailed, _levels[fine + 1].at(x, y), level - static_cast<double>(fine));
}

double OuterRelief::Level::at(double x, double y) const
{
    const double u = std::clamp(x * columns - 0.5, 0.0, columns - 1.0);
    const double v = std::clamp(y * rows - 0.5, 0.0, rows - 1.0);
    const int i = std::clamp(static_cast<int>(u), 0, std::max(columns - 2, 0));
    const int j = std::clamp(static_cast<int>(v), 0, std::max(rows - 2, 0));
    const int right = std::min(i + 1, columns - 1) - i, up = (std::min(j + 1, rows - 1) - j) * columns;
    const float* const cell = &values[static_cast<std::size_t>(j) * columns + i];
    return std::lerp(std::lerp(cell[0], cell[right], u - i), std::lerp(cell[up], cell[up + right], u - i),
                     v - j);
}

OuterRelief::Level OuterRelief::Level::half() const
{
    Level half{(columns + 1) / 2, (rows + 1) / 2, {}};
    for (int y = 0; y < half.rows; ++y)
        for (int x = 0; x < half.columns; ++x)
            half.values.push_back(
                static_cast<float>(at((x + 0.5) / half.columns,
                                      (y + 0.5) / half.rows))); // the middle of two or four cells: their mean
    return half;
}

} // namespace osgTerrainROAM
