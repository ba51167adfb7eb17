// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace islandgen
{

/// A square raster. Cell (column, row): column 0 is the westernmost, row 0 the southernmost; row-major.
/// Frame: plan kilometres or metres grow east with the column and north with the row; origin: cell (0, 0).
/// Invariant: cells.size() == side·side, side ≥ 2.
template<class T>
struct Grid
{
    int side = 0;
    std::vector<T> cells;

    explicit Grid(int sideCells, T value = T{})
        : side(sideCells), cells(static_cast<std::size_t>(sideCells) * sideCells, value)
    {
    }

    int count() const { return side * side; }
    int index(int column, int row) const { return row * side + column; }
    bool onEdge(int column, int row) const
    {
        return column == 0 || row == 0 || column == side - 1 || row == side - 1;
    }
    T& operator[](int cell) { return cells[static_cast<std::size_t>(cell)]; }
    const T& operator[](int cell) const { return cells[static_cast<std::size_t>(cell)]; }
    T& at(int column, int row) { return cells[static_cast<std::size_t>(index(column, row))]; }
    const T& at(int column, int row) const { return cells[static_cast<std::size_t>(index(column, row))]; }
    /// The nearest cell of the grid to a cell that may lie outside it.
    const T& clamped(int column, int row) const
    {
        return at(std::clamp(column, 0, side - 1), std::clamp(row, 0, side - 1));
    }
};

/// One of the eight neighbours of a cell; `distance` in cells.
struct NeighbourStep
{
    int column;
    int row;
    float distance;
};

inline constexpr float kDiagonal = 1.41421356f;
inline constexpr NeighbourStep kNeighbours[8] = {{1, 0, 1.0f},       {1, 1, kDiagonal}, {0, 1, 1.0f},
                                                 {-1, 1, kDiagonal}, {-1, 0, 1.0f},     {-1, -1, kDiagonal},
                                                 {0, -1, 1.0f},      {1, -1, kDiagonal}};

} // namespace islandgen
