// SPDX-License-Identifier: Apache-2.0
#include "Raster.h"

#include <cmath>

namespace islandgen
{

namespace
{

/// Running mean along one line of cells, `stride` apart.
void blurLine(float* line, int count, int stride, int radius, std::vector<float>& copy)
{
    copy.resize(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        copy[static_cast<std::size_t>(i)] = line[static_cast<std::ptrdiff_t>(i) * stride];
    const auto value = [&](int i)
    { return static_cast<double>(copy[static_cast<std::size_t>(std::clamp(i, 0, count - 1))]); };
    double sum = 0.0;
    for (int i = -radius; i <= radius; ++i)
        sum += value(i);
    for (int i = 0; i < count; ++i)
    {
        line[static_cast<std::ptrdiff_t>(i) * stride] = static_cast<float>(sum / (2 * radius + 1));
        sum += value(i + radius + 1) - value(i - radius);
    }
}

/// Per cell the distance to the nearest mark in its own column.
Grid<int> columnDistances(const Grid<std::uint8_t>& marked)
{
    const int n = marked.side;
    Grid<int> distance(n, 4 * n);
    for (int column = 0; column < n; ++column)
    {
        int last = 4 * n;
        for (int row = 0; row < n; ++row)
        {
            last = marked.at(column, row) ? 0 : std::min(last + 1, 4 * n);
            distance.at(column, row) = last;
        }
        for (int row = n - 1; row >= 0; --row)
        {
            last = marked.at(column, row) ? 0 : std::min(last + 1, 4 * n);
            distance.at(column, row) = std::min(distance.at(column, row), last);
        }
    }
    return distance;
}

} // namespace

Grid<float> blurred(const Grid<float>& grid, int radius)
{
    Grid<float> result = grid;
    std::vector<float> copy;
    for (int pass = 0; pass < 2; ++pass)
    {
        for (int row = 0; row < grid.side; ++row)
            blurLine(&result.at(0, row), grid.side, 1, radius, copy);
        for (int column = 0; column < grid.side; ++column)
            blurLine(&result.at(column, 0), grid.side, grid.side, radius, copy);
    }
    return result;
}

Grid<float> distanceTo(const Grid<std::uint8_t>& marked)
{
    const int n = marked.side;
    const Grid<int> inColumn = columnDistances(marked);
    Grid<float> result(n);
    std::vector<int> parabola(static_cast<std::size_t>(n));
    std::vector<int> start(static_cast<std::size_t>(n));
    for (int row = 0; row < n; ++row)
    {
        const auto squared = [&](int x, int i)
        {
            const auto g = static_cast<std::int64_t>(inColumn.at(i, row));
            return static_cast<std::int64_t>(x - i) * (x - i) + g * g;
        };
        std::size_t top = 0;
        parabola[0] = start[0] = 0;
        for (int u = 1; u < n; ++u)
        {
            bool empty = false;
            while (!empty && squared(start[top], parabola[top]) > squared(start[top], u))
            {
                if (top == 0)
                    empty = true;
                else
                    --top;
            }
            if (empty)
            {
                parabola[0] = u;
                continue;
            }
            const std::int64_t i = parabola[top];
            const std::int64_t gu = inColumn.at(u, row);
            const std::int64_t gi = inColumn.at(static_cast<int>(i), row);
            const std::int64_t from = 1 + (std::int64_t{u} * u - i * i + gu * gu - gi * gi) / (2 * (u - i));
            if (from >= n) continue;
            ++top;
            parabola[top] = u;
            start[top] = static_cast<int>(from);
        }
        for (int x = n - 1; x >= 0; --x)
        {
            const double d2 = static_cast<double>(squared(x, parabola[top]));
            result.at(x, row) = static_cast<float>(std::min(std::sqrt(d2), 4.0 * n));
            if (x == start[top] && top > 0) --top;
        }
    }
    return result;
}

} // namespace islandgen
