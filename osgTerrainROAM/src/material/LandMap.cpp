// SPDX-License-Identifier: Apache-2.0
#include "LandMap.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

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

/// Gives heights without data the value NaN: their filler is flat and would be taken for water.
MapField withoutHoles(MapField heights, const core::PlacedTile& tile, const MapGrid& grid)
{
    std::size_t at = 0;
    for (int y = 0; y < grid.height && tile.samples().hasHoles(); ++y)
        for (int x = 0; x < grid.width; ++x, ++at)
            if (!tile.samples().isGround(x * grid.step, y * grid.step))
                heights[at] = std::numeric_limits<float>::quiet_NaN();
    return heights;
}

/// Smooths vegetation and snow over the neighbouring texels: thresholds of single samples would draw the lattice.
void smooth(osg::Image& land)
{
    const osg::ref_ptr<osg::Image> before = new osg::Image(land, osg::CopyOp::DEEP_COPY_ALL);
    const int width = land.s(), height = land.t();
    const auto rows = [&](int first, int end)
    {
        for (int y = first; y < end; ++y)
            for (int x = 0; x < width; ++x)
                for (int channel = 0; channel < 2; ++channel)
                {
                    int sum = 8; // of weights 16, rounded
                    for (int j = -1; j <= 1; ++j)
                        for (int i = -1; i <= 1; ++i)
                            sum += (2 - std::abs(i)) * (2 - std::abs(j)) *
                                   before->data(std::clamp(x + i, 0, width - 1),
                                                std::clamp(y + j, 0, height - 1))[channel];
                    land.data(x, y)[channel] = static_cast<unsigned char>(sum / 16);
                }
    };
    parallelRows(height, rows);
}

} // namespace

osg::ref_ptr<osg::Image> landMap(const core::PlacedTile& tile, const MapGrid& grid, const Climate& climate,
                                 const osg::Image& normals)
{
    const double spacingM = grid.spacingM(tile);
    const MapField heights = mapHeights(tile, grid);
    const MapField hollow = hollowness(heights, grid, spacingM);
    const std::vector<std::uint8_t> water =
        waterMask(withoutHoles(heights, tile, grid), grid, climate.seaLevelM);
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
