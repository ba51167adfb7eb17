// SPDX-License-Identifier: Apache-2.0
#include "RasterSampler.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kAtSample = 1e-3;
constexpr float kVoid = std::numeric_limits<float>::quiet_NaN();

/// Source: Keys, *Cubic Convolution Interpolation for Digital Image Processing*, 1981, with a = -1/2.
void cubicWeights(double t, double (&w)[4])
{
    w[0] = t * (-0.5 + t * (1.0 - 0.5 * t));
    w[1] = 1.0 + t * t * (-2.5 + 1.5 * t);
    w[2] = t * (0.5 + t * (2.0 - 1.5 * t));
    w[3] = t * t * (-0.5 + 0.5 * t);
}

double snapped(double coordinate)
{
    const double whole = std::round(coordinate);
    return std::abs(coordinate - whole) < kAtSample ? whole : coordinate;
}

} // namespace

float RasterSampler::sample(int column, int row) const
{
    const int c = std::clamp(column, 0, _raster.columns - 1), r = std::clamp(row, 0, _raster.rows - 1);
    return _raster.heightsM[static_cast<std::size_t>(r) * static_cast<std::size_t>(_raster.columns) +
                            static_cast<std::size_t>(c)];
}

double RasterSampler::beyond(const glm::dvec2& place) const
{
    const glm::dvec2 last(_raster.columns - 1, _raster.rows - 1), beyond = glm::max(-place, place - last);
    return std::max({beyond.x - kAtSample, beyond.y - kAtSample, 0.0});
}

float RasterSampler::heightM(glm::dvec2 place) const
{
    if (!std::isfinite(place.x + place.y) || beyond(place) > 0.0) return kVoid;
    place = {snapped(place.x), snapped(place.y)};
    const int column = std::clamp(static_cast<int>(std::floor(place.x)), 0, _raster.columns - 1);
    const int row = std::clamp(static_cast<int>(std::floor(place.y)), 0, _raster.rows - 1);
    const double east = place.x - column, north = place.y - row;
    // A sample that has no part in the place may be void.
    const float sw = sample(column, row), se = east > 0.0 ? sample(column + 1, row) : sw;
    const float nw = north > 0.0 ? sample(column, row + 1) : sw;
    const float ne = east > 0.0 && north > 0.0 ? sample(column + 1, row + 1) : east > 0.0 ? se : nw;
    if (east <= 0.0 && north <= 0.0) return sw;
    const double straight =
        std::lerp(std::lerp(double{sw}, double{se}, east), std::lerp(double{nw}, double{ne}, east), north);
    if (!std::isfinite(straight)) return kVoid;

    double alongEast[4], alongNorth[4], sum = 0.0;
    cubicWeights(east, alongEast);
    cubicWeights(north, alongNorth);
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 4; ++i)
            if (const double w = alongEast[i] * alongNorth[j]; w != 0.0)
                sum += w * sample(column + i - 1, row + j - 1);
    if (!std::isfinite(sum)) return static_cast<float>(straight);
    const auto [low, high] = std::minmax({sw, se, nw, ne});
    return std::clamp(static_cast<float>(sum), low, high);
}

} // namespace osgTerrainROAM::core
