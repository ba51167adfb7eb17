// SPDX-License-Identifier: Apache-2.0
#include "Resample.h"

#include <array>

namespace islandgen
{

namespace
{

std::array<float, 4> catmullRomWeights(float t)
{
    const float t2 = t * t;
    const float t3 = t2 * t;
    return {0.5f * (-t + 2.0f * t2 - t3), 0.5f * (2.0f - 5.0f * t2 + 3.0f * t3),
            0.5f * (t + 4.0f * t2 - 3.0f * t3), 0.5f * (t3 - t2)};
}

} // namespace

float interpolated(const Grid<float>& grid, float column, float row)
{
    const float last = static_cast<float>(grid.side - 1);
    column = std::clamp(column, 0.0f, last);
    row = std::clamp(row, 0.0f, last);
    const int c = std::min(static_cast<int>(column), grid.side - 2);
    const int r = std::min(static_cast<int>(row), grid.side - 2);
    const auto alongColumns = catmullRomWeights(column - static_cast<float>(c));
    const auto alongRows = catmullRomWeights(row - static_cast<float>(r));
    float sum = 0.0f;
    for (int j = 0; j < 4; ++j)
    {
        float line = 0.0f;
        for (int i = 0; i < 4; ++i)
        {
            line += alongColumns[static_cast<std::size_t>(i)] * grid.clamped(c + i - 1, r + j - 1);
        }
        sum += alongRows[static_cast<std::size_t>(j)] * line;
    }
    return sum;
}

Grid<float> resampled(const Grid<float>& grid, int side)
{
    return resampledBent(grid, side, Noise(0), 1.0f, 0.0f);
}

Grid<float> resampledBent(const Grid<float>& grid, int side, Noise noise, float wavelength, float amplitude)
{
    Grid<float> result(side);
    const float scale = static_cast<float>(grid.side - 1) / static_cast<float>(side - 1);
    for (int row = 0; row < side; ++row)
    {
        for (int column = 0; column < side; ++column)
        {
            float x = static_cast<float>(column);
            float y = static_cast<float>(row);
            if (amplitude > 0.0f)
            {
                const float u = x / wavelength;
                const float v = y / wavelength;
                x += amplitude * noise.channel(1).fractal(u, v, 2);
                y += amplitude * noise.channel(2).fractal(u, v, 2);
            }
            result.at(column, row) = interpolated(grid, x * scale, y * scale);
        }
    }
    return result;
}

} // namespace islandgen
