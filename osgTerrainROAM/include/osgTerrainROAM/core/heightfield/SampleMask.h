// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace osgTerrainROAM::core
{

/// A mask tells which samples of a raster exist: data can have an outline and holes. A default-constructed
/// mask has all samples. It keeps a bit for each sample, and for each 64 samples the number of bits before
/// them in the row: counting in a row takes constant time. Row 0 is the southernmost. Threads: immutable.
/// Memory: 10 B per 64 samples; none when all samples exist.
class SampleMask
{
public:
    SampleMask() = default;

    /// `isThere`: columns × rows values, row-major, 0 where there is no sample.
    SampleMask(std::span<const std::uint8_t> isThere, int columns, int rows)
        : _wordsPerRow((static_cast<std::size_t>(columns) + 63) / 64)
    {
        _words.assign(_wordsPerRow * static_cast<std::size_t>(rows), 0);
        _before.assign(_words.size(), 0);
        for (int row = 0; row < rows; ++row)
        {
            const auto* samples = &isThere[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns)];
            const std::size_t first = static_cast<std::size_t>(row) * _wordsPerRow;
            for (int column = 0; column < columns; ++column)
                if (samples[column]) _words[first + static_cast<std::size_t>(column) / 64] |= bit(column);
            for (std::size_t i = 1; i < _wordsPerRow; ++i)
                _before[first + i] =
                    static_cast<std::uint16_t>(_before[first + i - 1] + std::popcount(_words[first + i - 1]));
        }
    }

    bool hasAll() const { return _words.empty(); }
    bool holds(int column, int row) const
    {
        return hasAll() || (_words[wordOf(column, row)] & bit(column)) != 0;
    }

    /// Counts the samples of a row from `west` to `east`, both included, that exist.
    int countIn(int row, int west, int east) const
    {
        return hasAll() ? east - west + 1
                        : countBefore(row, east) + (holds(east, row) ? 1 : 0) - countBefore(row, west);
    }

    std::size_t memoryBytes() const { return _words.capacity() * 8 + _before.capacity() * 2; }

private:
    static std::uint64_t bit(int column) { return std::uint64_t{1} << (column & 63); }
    std::size_t wordOf(int column, int row) const
    {
        return static_cast<std::size_t>(row) * _wordsPerRow + static_cast<std::size_t>(column) / 64;
    }
    int countBefore(int row, int column) const
    {
        const std::size_t word = wordOf(column, row);
        return _before[word] + std::popcount(_words[word] & (bit(column) - 1));
    }

    std::size_t _wordsPerRow = 0;
    std::vector<std::uint64_t> _words;
    std::vector<std::uint16_t> _before; ///< by word: samples of the row before it
};

} // namespace osgTerrainROAM::core
