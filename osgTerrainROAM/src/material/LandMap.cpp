// SPDX-License-Identifier: Apache-2.0
#include "LandMap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "GroundRule.h"
#include "NormalMap.h"
#include "ParallelRows.h"
#include "SkyVisibility.h"
#include "WaterMask.h"

namespace osgTerrainROAM
{

namespace
{

unsigned char byteOf(double share)
{
    return static_cast<unsigned char>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

/// Estimates water as waterMask() does, but not where there is no data, whose filler is flat, nor where edits
/// have put samples: the bed of a road may be level too.
std::vector<std::uint8_t> waterOf(MapField heights, const core::PlacedTile& tile, const MapGrid& grid,
                                  const Climate& climate)
{
    if (climate.water == core::WaterRule::none) return std::vector<std::uint8_t>(heights.size(), 0);
    const auto& samples = tile.samples();
    const bool isPlain = !samples.hasHoles() && samples.fineSamples().isEmpty();
    std::size_t at = 0;
    for (int y = 0; y < grid.height && !isPlain; ++y)
        for (int x = 0; x < grid.width; ++x, ++at)
            if (!samples.isGround(x * grid.step, y * grid.step) ||
                samples.hasFineSample(x * grid.step, y * grid.step))
                heights[at] = std::numeric_limits<float>::quiet_NaN();
    return waterMask(heights, grid, climate.seaLevelM, climate.water == core::WaterRule::level);
}

/// Smooths vegetation and snow over the neighbouring texels: thresholds of single samples would draw the
/// lattice. The weights are 1, 2, 1 along each axis; beyond the edge its texels count again.
void smooth(osg::Image& land)
{
    constexpr int kChannels = 2, kTexelBytes = 4;
    const int width = land.s(), height = land.t();
    std::vector<std::uint16_t> along(static_cast<std::size_t>(width) * height *
                                     kChannels); // sums within a row
    const auto sumsOf = [&](int y) { return &along[static_cast<std::size_t>(y) * width * kChannels]; };
    const auto addAlong = [&](int first, int end)
    {
        for (int y = first; y < end; ++y)
        {
            const unsigned char* const row = land.data(0, y);
            std::uint16_t* out = sumsOf(y);
            for (int x = 0; x < width; ++x)
                for (int channel = 0; channel < kChannels; ++channel)
                {
                    const auto at = [&](int column) { return row[column * kTexelBytes + channel]; };
                    const int sides = at(std::max(x - 1, 0)) + at(std::min(x + 1, width - 1));
                    *out++ = static_cast<std::uint16_t>(sides + 2 * at(x));
                }
        }
    };
    const auto addAcross = [&](int first, int end)
    {
        for (int y = first; y < end; ++y)
        {
            const std::uint16_t* const south = sumsOf(std::max(y - 1, 0));
            const std::uint16_t* const here = sumsOf(y);
            const std::uint16_t* const north = sumsOf(std::min(y + 1, height - 1));
            unsigned char* const row = land.data(0, y);
            for (int i = 0; i < width * kChannels; ++i)
                row[i / kChannels * kTexelBytes + i % kChannels] =
                    static_cast<unsigned char>((south[i] + 2 * here[i] + north[i] + 8) / 16);
        }
    };
    parallelRows(height, addAlong);
    parallelRows(height, addAcross);
}

} // namespace

osg::ref_ptr<osg::Image> landMap(const core::PlacedTile& tile, const MapGrid& grid, const Climate& climate,
                                 const osg::Image& normals)
{
    const double spacingM = grid.spacingM(tile);
    const MapField heights = mapHeights(tile, grid);
    const MapField hollow = hollowness(heights, grid, spacingM);
    const std::vector<std::uint8_t> water = waterOf(heights, tile, grid, climate);
    const GroundRule rule(climate, spacingM);
    const double sunSide = tile.field().net && tile.field().net->nodes.front().latitudeDeg < 0.0 ? 1.0 : -1.0;

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(grid.width, grid.height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    image->setInternalTextureFormat(GL_RGBA8);
    const auto rows = [&](int first, int end)
    {
        for (int y = first; y < end; ++y)
        {
            unsigned char* out = image->data(0, y);
            for (int x = 0; x < grid.width; ++x, out += 4)
            {
                const std::size_t at = static_cast<std::size_t>(y) * grid.width + x;
                const glm::dvec2 tilt = tiltAt(normals, x, y);
                const double tilt2 = std::min(glm::dot(tilt, tilt), 0.9975);
                const GroundSite site{heights[at], std::sqrt(tilt2 / (1.0 - tilt2)), sunSide * tilt.y,
                                      hollow[at], rule.noiseAt(x * spacingM, y * spacingM)};
                out[0] = byteOf(rule.vegetation(site));
                out[1] = byteOf(rule.snow(site));
                out[2] = water[at];
                out[3] = byteOf(skyVisibility(hollow[at]));
            }
        }
    };
    parallelRows(grid.height, rows);
    smooth(*image);
    return image;
}

} // namespace osgTerrainROAM
