// SPDX-License-Identifier: Apache-2.0
// Source: Wilson and Gallant, Terrain Analysis (2000), chapter 3: the difference from mean elevation over
// several scales, here computed from an image pyramid.
#include "SkyVisibility.h"

#include <cmath>

#include "ParallelRows.h"

namespace osgTerrainROAM
{

namespace
{

struct HeightLevel
{
    int width, height;
    MapField values;

    float at(int x, int y) const
    {
        return values[static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * width +
                      std::clamp(x, 0, width - 1)];
    }
    float sample(float x, float y) const
    {
        const int i = static_cast<int>(std::floor(x));
        const int j = static_cast<int>(std::floor(y));
        const float fx = x - static_cast<float>(i);
        const float fy = y - static_cast<float>(j);
        return std::lerp(std::lerp(at(i, j), at(i + 1, j), fx), std::lerp(at(i, j + 1), at(i + 1, j + 1), fx),
                         fy);
    }
};

HeightLevel halved(const HeightLevel& fine)
{
    HeightLevel coarse{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
    coarse.values.resize(static_cast<std::size_t>(coarse.width) * coarse.height);
    // The filter is a tent of 4×4 texels, so that bilinear interpolation shows no squares.
    constexpr float kTent[4] = {0.125f, 0.375f, 0.375f, 0.125f};
    parallelRows(coarse.height,
                 [&](int first, int end)
                 {
                     for (int y = first; y < end; ++y)
                         for (int x = 0; x < coarse.width; ++x)
                         {
                             float sum = 0.0f;
                             for (int j = 0; j < 4; ++j)
                                 for (int i = 0; i < 4; ++i)
                                     sum += kTent[i] * kTent[j] * fine.at(2 * x - 1 + i, 2 * y - 1 + j);
                             coarse.values[static_cast<std::size_t>(y) * coarse.width + x] = sum;
                         }
                 });
    return coarse;
}

} // namespace

MapField mapHeights(const core::PlacedTile& tile, const MapGrid& grid)
{
    MapField heights(static_cast<std::size_t>(grid.width) * grid.height);
    for (int y = 0; y < grid.height; ++y)
        for (int x = 0; x < grid.width; ++x)
            heights[static_cast<std::size_t>(y) * grid.width + x] =
                tile.samples().heightM(x * grid.step, y * grid.step);
    return heights;
}

MapField hollowness(const MapField& heights, const MapGrid& grid, double spacingM)
{
    constexpr int kScales = 6;
    MapField hollow(heights.size(), 0.0f);
    HeightLevel level{grid.width, grid.height, heights};
    for (int k = 1; k <= kScales && std::min(level.width, level.height) > 2; ++k)
    {
        level = halved(level);
        const auto scale = static_cast<float>(1 << k);
        const float gain = 1.0f / (scale * static_cast<float>(spacingM) * std::sqrt(scale) * 0.5f);
        parallelRows(grid.height,
                     [&](int first, int end)
                     {
                         for (int y = first; y < end; ++y)
                             for (int x = 0; x < grid.width; ++x)
                             {
                                 const std::size_t at = static_cast<std::size_t>(y) * grid.width + x;
                                 const float mean =
                                     level.sample((static_cast<float>(x) + 0.5f) / scale - 0.5f,
                                                  (static_cast<float>(y) + 0.5f) / scale - 0.5f);
                                 hollow[at] += (mean - heights[at]) * gain;
                             }
                     });
    }
    return hollow;
}

float skyVisibility(float hollow)
{
    // A plain has 0.8 of the value of a summit, so that both valleys and ridges show.
    return std::clamp(0.8f - 0.9f * hollow / (1.0f + std::abs(hollow)), 0.25f, 1.0f);
}

} // namespace osgTerrainROAM
