// SPDX-License-Identifier: Apache-2.0
#include "OuterGround.h"

#include <algorithm>
#include <cmath>

namespace osgTerrainROAM
{

namespace
{

constexpr double kEarthRadiusM = 6371000.0;
constexpr int kReliefSide = 192; ///< cells of the relief along the longer side
constexpr int kReliefMean = 12;  ///< half width, in cells, of the mean that it is counted from
constexpr double kWindow = 0.7;  ///< half width of the stretch of border, as a share of the distance to it
constexpr double kHillsM[] = {6e3, 25e3, 100e3}; ///< wavelengths of the noise

/// Wavelengths of coasts, the share of a wave by which they swing (six standard deviations), and the most of the distance from the data.
constexpr double kCoastsM[] = {1.5e3, 6e3, 25e3, 100e3};
constexpr double kSwing = 2.0, kSwingPerDistance = 1.2;
/// How much noise adds to a share of water of one half, for six standard deviations: bays and islands.
constexpr double kBays = 1.2;

double stepped(double low, double high, double x)
{
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

/// Folds a coordinate back into 0…last, as between two mirrors.
double mirrored(double x, double last)
{
    const double fold = std::abs(std::remainder(x, 2.0 * last));
    return std::min(fold, last);
}

bool isWater(const osg::Image& land, int x, int y)
{
    return land.data(x, y)[2] >= 128;
}

/// Subtracts from each value the mean of the square around it.
std::vector<float> lessLocalMean(const std::vector<float>& heights, int columns, int rows)
{
    const auto width = static_cast<std::size_t>(columns) + 1;
    std::vector<double> sums(width * (static_cast<std::size_t>(rows) + 1), 0.0);
    const auto sum = [&](int x, int y) -> double& { return sums[static_cast<std::size_t>(y) * width + x]; };
    const auto at = [&](int x, int y) { return static_cast<std::size_t>(y) * columns + x; };
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            sum(x + 1, y + 1) = heights[at(x, y)] + sum(x, y + 1) + sum(x + 1, y) - sum(x, y);
    std::vector<float> less(heights.size());
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
        {
            const int west = std::max(x - kReliefMean, 0), east = std::min(x + kReliefMean + 1, columns);
            const int south = std::max(y - kReliefMean, 0), north = std::min(y + kReliefMean + 1, rows);
            const double mean = (sum(east, north) - sum(west, north) - sum(east, south) + sum(west, south)) /
                                ((east - west) * (north - south));
            less[at(x, y)] = heights[at(x, y)] - static_cast<float>(mean);
        }
    return less;
}

} // namespace

OuterGround::OuterGround(const core::PlacedTile& tile, const osg::Image& land)
    : _tile(tile),
      _land(land),
      _map(tile),
      _border(tile, _map, [&](int x, int y) { return isWater(land, x, y); }),
      _last(tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1),
      _gridFromLocal(tile.frame().gridMap().linear),
      _localFromGrid(glm::inverse(_gridFromLocal)),
      _spacingM(0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM)),
      _sideM(_spacingM * std::max(tile.field().columns, tile.field().rows)),
      _noise(256, {4, 5, 0.55, 97})
{
    makeRelief();
}

void OuterGround::makeRelief()
{
    const double cell = std::max(_last.x, _last.y) / kReliefSide;
    _reliefColumns = std::clamp(static_cast<int>(std::lround(_last.x / cell)), 1, kReliefSide) + 1;
    _reliefRows = std::clamp(static_cast<int>(std::lround(_last.y / cell)), 1, kReliefSide) + 1;
    std::vector<float> heights;
    for (int y = 0; y < _reliefRows; ++y)
        for (int x = 0; x < _reliefColumns; ++x)
        {
            const glm::dvec2 share(x / (_reliefColumns - 1.0), y / (_reliefRows - 1.0));
            heights.push_back(static_cast<float>(heightNear(share * _last)));
        }
    _lowestM = *std::min_element(heights.begin(), heights.end());
    _relief = lessLocalMean(heights, _reliefColumns, _reliefRows);
    double squares = 0.0;
    for (const float value : _relief)
        squares += static_cast<double>(value) * value;
    _deviationM = std::sqrt(squares / static_cast<double>(_relief.size()));
}

/// Height of the raster's sample nearest to a position of the data.
double OuterGround::heightNear(const glm::dvec2& grid) const
{
    const int cell = _tile.grid().cellSide();
    const glm::ivec2 sample(glm::round(grid / static_cast<double>(cell)));
    return _tile.samples().heightM(sample.x * cell, sample.y * cell);
}

double OuterGround::reliefAt(const glm::dvec2& grid) const
{
    const double x = mirrored(grid.x, _last.x) / _last.x * (_reliefColumns - 1);
    const double y = mirrored(grid.y, _last.y) / _last.y * (_reliefRows - 1);
    const int i = std::min(static_cast<int>(x), _reliefColumns - 2);
    const int j = std::min(static_cast<int>(y), _reliefRows - 2);
    const float* const row = &_relief[static_cast<std::size_t>(j) * _reliefColumns + i];
    return std::lerp(std::lerp(row[0], row[1], x - i),
                     std::lerp(row[_reliefColumns], row[_reliefColumns + 1], x - i), y - j);
}

/// The hills beyond the border: those of the data, and noise of wavelengths that the data do not have.
double OuterGround::hillsM(const glm::dvec2& grid, double distanceM) const
{
    const double onsetM = std::max(0.02 * _sideM, 8.0 * _spacingM);
    double hills = reliefAt(grid) * stepped(0.5 * onsetM, 5.0 * onsetM, distanceM);
    const glm::dvec2 place = _localFromGrid * grid;
    for (const double wave : kHillsM)
    {
        if (wave < 0.5 * _sideM) continue;
        const double amplitude = std::min(2.0 * _deviationM, 0.012 * wave);
        const double noise = _noise.sample(place.x / (4.0 * wave), place.y / (4.0 * wave)) - 0.5;
        hills += 3.0 * amplitude * noise * stepped(0.1 * wave, wave, distanceM);
    }
    return hills;
}

/// The noise of all coasts, each limited in proportion to the distance from the data, in metres. `shift`: of the noise, in its periods.
double OuterGround::coastNoiseM(const glm::dvec2& place, double distanceM, double shift) const
{
    double noiseM = 0.0;
    for (const double wave : kCoastsM)
        noiseM += std::min(kSwing * wave, kSwingPerDistance * distanceM) *
                  (_noise.sample(place.x / (4.0 * wave) + shift, place.y / (4.0 * wave) - shift) - 0.5);
    return noiseM;
}

/// The border beside a place: not the nearest part of it, or coasts would run out in straight lines. They wind, the more the farther
/// out, and have bays and islands.
BorderLoop::Means OuterGround::borderBeside(const glm::dvec2& grid, const glm::dvec2& border,
                                            double samples) const
{
    const glm::dvec2 place = _localFromGrid * grid;
    const double distanceM = samples * _spacingM;
    const double nearest = _border.positionOf(border / static_cast<double>(_tile.grid().cellSide()));
    const double aside = coastNoiseM(place, distanceM, 0.0) / _spacingM;
    BorderLoop::Means means = _border.around(nearest + aside, kWindow * samples);
    const double bays = coastNoiseM(place, distanceM, 0.37) / std::max(kSwingPerDistance * distanceM, 1e-9);
    means.water = std::clamp(means.water + kBays * bays * 4.0 * means.water * (1.0 - means.water), 0.0, 1.0);
    return means;
}

OuterGround::Site OuterGround::at(const glm::dvec2& grid) const
{
    const glm::dvec2 border = glm::clamp(grid, glm::dvec2(0.0), _last);
    const glm::dvec2 beyond = grid - border;
    if (beyond == glm::dvec2(0.0))
    {
        const glm::ivec2 texel = glm::min(glm::ivec2(glm::round(grid / static_cast<double>(_map.step))),
                                          glm::ivec2(_map.width - 1, _map.height - 1));
        return {heightNear(grid), isWater(_land, texel.x, texel.y) ? 1.0 : 0.0};
    }
    const double perSample = 1.0 / _tile.grid().cellSide();
    const double samples = glm::length(beyond) * perSample;
    const double distanceM = samples * _spacingM;
    const BorderLoop::Means means = borderBeside(grid, border, samples);
    // The slope goes on across the border: the data are turned about the point there, and soon fade.
    const double fadeM = std::max(0.012 * _sideM, 4.0 * _spacingM);
    const double turned =
        heightNear(border) - heightNear(glm::clamp(border - beyond, glm::dvec2(0.0), _last));
    double land = means.heightM + turned * std::exp(-distanceM * distanceM / (fadeM * fadeM));
    land = std::max(land + hillsM(grid, distanceM), std::min(_lowestM, means.heightM));
    const double dry = stepped(0.0, 0.5, 0.5 - means.water);
    return {std::lerp(means.waterHeightM, land, dry), means.water};
}

glm::dvec3 OuterGround::position(const glm::dvec2& grid, double heightM) const
{
    const glm::dvec2 border = glm::clamp(grid, glm::dvec2(0.0), _last);
    const glm::dvec3 at = _tile.frame().positionAt(border.x, border.y, heightM);
    const glm::dvec2 plan = glm::dvec2(at) + _localFromGrid * (grid - border);
    if (_tile.frame().placement() == core::Placement::planar) return {plan, at.z};
    const double fallM = (glm::dot(plan, plan) - at.x * at.x - at.y * at.y) / (2.0 * kEarthRadiusM);
    return {plan, at.z - fallM};
}

} // namespace osgTerrainROAM
