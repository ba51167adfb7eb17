// SPDX-License-Identifier: Apache-2.0
#include "LandMap.h"

#include <cmath>
#include <limits>

#include "NormalMap.h"
#include "ParallelRows.h"
#include "SkyVisibility.h"
#include "TileableNoise.h"
#include "WaterMask.h"

namespace osgTerrainROAM
{

namespace
{

struct Place
{
    double heightM;
    double steepness; ///< tangent of the slope
    double southness; ///< −1 faces away from the midday sun … 1 faces it
    double hollow;    ///< SkyVisibility.h
    double noise;     ///< −½…½, patches of many sizes
};

double stepped(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// The rule of vegetation. All numbers were chosen by eye.
class Growth
{
public:
    Growth(const Climate& climate, double spacingM) : _climate(climate)
    {
        // Coarse samples smooth slopes: the real ones, which hold trees and snow, are steeper.
        _slopeGain = std::clamp(std::pow(spacingM / 10.0, 0.2), 0.8, 1.5);
    }

    double vegetation(const Place& p) const
    {
        const double line = _climate.treeLineM + 120.0 * p.southness + 300.0 * p.noise;
        const double below = line - p.heightM;
        const double band = std::max(0.12 * _climate.treeLineM, 120.0);
        double green = 0.30 + 0.32 * stepped(-3.2 * band, -0.5 * band, below) +
                       0.36 * stepped(-0.6 * band, 1.1 * band, below);
        green -= 0.25 * stepped(-1.5 * band, -5.0 * band, below);
        // Valley floors and gentle ground are open land, slopes carry the woods.
        const double gentle = 1.0 - stepped(0.04, 0.16, p.steepness * _slopeGain);
        green -= 0.33 * gentle * stepped(0.5 * band, 1.5 * band, below) *
                 stepped(-0.25, 0.1, p.hollow + 0.5 * p.noise);
        green += 0.75 * p.noise + 0.25 * std::clamp(p.hollow, -0.6, 0.6);
        // Below the tree line roots hold slopes; above it such slopes are scree.
        const double holds = 0.75 + 0.45 * stepped(-band, band, below);
        green -= 0.95 * stepped(holds, holds + 0.7, p.steepness * _slopeGain);
        return std::clamp(green * (1.0 - 0.72 * _climate.aridity) + 0.06 * _climate.aridity, 0.0, 1.0);
    }

    double snow(const Place& p) const
    {
        const double line = _climate.snowLineM + 250.0 * p.southness -
                            220.0 * std::clamp(p.hollow, -0.7, 0.7) + 350.0 * p.noise;
        const double deep = stepped(-450.0, 450.0, p.heightM - line);
        return deep * (1.0 - 0.85 * stepped(0.9, 1.7, p.steepness * _slopeGain));
    }

private:
    Climate _climate;
    double _slopeGain;
};

unsigned char byteOf(double share)
{
    return static_cast<unsigned char>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

/// Noise by position in metres, −½…½: periods of 60 samples (300 m … 6 km), and of 3.73 times that, rotated.
double landNoise(const TileableNoise& noise, double eastM, double northM, double spacingM)
{
    const double fine = std::clamp(spacingM * 60.0, 300.0, 6000.0);
    const double coarse = 3.73 * fine;
    return 0.6 * noise.sample(eastM / fine, northM / fine) +
           0.6 * noise.sample((0.8 * eastM - 0.6 * northM) / coarse, (0.6 * eastM + 0.8 * northM) / coarse) -
           0.6;
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

} // namespace

osg::ref_ptr<osg::Image> landMap(const core::PlacedTile& tile, const MapGrid& grid, const Climate& climate,
                                 const osg::Image& normals)
{
    const double spacingM = grid.spacingM(tile);
    const MapField heights = mapHeights(tile, grid);
    const MapField hollow = hollowness(heights, grid, spacingM);
    const std::vector<std::uint8_t> water =
        waterMask(withoutHoles(heights, tile, grid), grid, climate.seaLevelM);
    const TileableNoise noise(256, {4, 5, 0.6, 71});
    const Growth growth(climate, spacingM);
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
                const Place place{heights[at], std::sqrt(tilt2 / (1.0 - tilt2)), sunSide * tilt.y, hollow[at],
                                  landNoise(noise, x * spacingM, y * spacingM, spacingM)};
                out[0] = byteOf(growth.vegetation(place));
                out[1] = byteOf(growth.snow(place));
                out[2] = water[at];
                out[3] = byteOf(skyVisibility(hollow[at]));
            }
        }
    };
    parallelRows(grid.height, rows);
    return image;
}

} // namespace osgTerrainROAM
