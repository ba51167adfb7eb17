// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgTerrainROAM::core
{

/// For each point of a grid, the nearest of the marked points and its distance.
/// Source: Danielsson, *Euclidean Distance Mapping*, 1980: two sweeps propagate the offset to the nearest
/// point; distances are less than one grid step above the exact ones.
class NearestSample
{
public:
    /// `isMarked`: row-major, columns × rows, each side below 32768.
    NearestSample(std::span<const std::uint8_t> isMarked, int columns, int rows);

    /// Linear index of the nearest marked point; undefined when none is marked.
    std::size_t nearest(int column, int row) const;

    /// Its distance in grid steps; larger than any grid when none is marked.
    double distance(int column, int row) const;

private:
    struct Offset
    {
        std::int16_t columns, rows; ///< to the nearest
    };
    static constexpr std::int16_t kFar = 32767;

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(_columns) +
               static_cast<std::size_t>(column);
    }
    void sweep(int row, int fromRow);
    void take(int column, int row, int fromColumn, int fromRow);

    int _columns, _rows;
    std::vector<Offset> _offsets;
};

} // namespace osgTerrainROAM::core
