// SPDX-License-Identifier: Apache-2.0
#include "OuterGround.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <foundation/Earth.h>
#include <glm/common.hpp>

namespace osgTerrainROAM
{

namespace
{

constexpr int kReliefSide = 192; ///< cells of the relief along the longer side
constexpr double kWindow = 0.7;  ///< half width of the stretch of border, as a share of the distance to it
constexpr double kHillsM[] = {6e3, 25e3, 100e3}; ///< wavelengths of the noise

/// Wavelengths of coasts, the share of a wave by which they swing (six standard deviations), and the most of
/// the distance from the data.
constexpr double kCoastsM[] = {1.5e3, 6e3, 25e3, 100e3};
constexpr double kSwing = 2.0, kSwingPerDistance = 1.2;
/// How much noise adds to a share of water of one half, for six standard deviations: bays and islands.
constexpr double kBays = 1.2;

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

} // namespace

OuterGround::OuterGround(const core::PlacedTile& tile, const osg::Image& land, double reachM)
    : _tile(tile),
      _land(land),
      _map(tile),
      _border(tile, _map, [&](int x, int y) { return isWater(land, x, y); }),
      _last(tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1),
      _gridFromLocal(tile.frame().gridMap().linear),
      _localFromGrid(glm::inverse(_gridFromLocal)),
      _spacingM(0.5 * (tile.field().spacingEastM + tile.field().spacingNorthM)),
      _sideM(_spacingM * std::max(tile.field().columns, tile.field().rows)),
      _noise(256, {4, 5, 0.55, 97}),
      _columns(_last.x, reachM / _spacingM * tile.grid().cellSide()),
      _rows(_last.y, reachM / _spacingM * tile.grid().cellSide())
{
    makeRelief();
}

void OuterGround::makeRelief()
{
    const double cell = std::max(_last.x, _last.y) / kReliefSide;
    const int columns = std::clamp(static_cast<int>(std::lround(_last.x / cell)), 1, kReliefSide) + 1;
    const int rows = std::clamp(static_cast<int>(std::lround(_last.y / cell)), 1, kReliefSide) + 1;
    std::vector<float> heights;
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < columns; ++x)
            heights.push_back(
                static_cast<float>(heightNear(glm::dvec2((x + 0.5) / columns, (y + 0.5) / rows) * _last)));
    _lowestM = *std::min_element(heights.begin(), heights.end());
    _relief = OuterRelief(columns, rows, heights);
    _reliefCellM = cell * _spacingM / _tile.grid().cellSide();
}

/// Height of the raster's sample nearest to a position of the data.
double OuterGround::heightNear(const glm::dvec2& grid) const
{
    const int cell = _tile.grid().cellSide();
    const glm::ivec2 sample(glm::round(grid / static_cast<double>(cell)));
    return _tile.samples().heightM(sample.x * cell, sample.y * cell);
}

double OuterGround::reliefAt(const glm::dvec2& grid, double texelM) const
{
    constexpr double kTexelsACell = 1.5;
    return _relief.at(mirrored(grid.x, _last.x) / _last.x, mirrored(grid.y, _last.y) / _last.y,
                      std::max(1.0, kTexelsACell * texelM / _reliefCellM));
}

/// The hills beyond the border: those of the data, and noise of wavelengths that the data do not have; each
/// where texels are fine enough for it.
double OuterGround::hillsM(const glm::dvec2& grid, double distanceM) const
{
    const double onsetM = std::max(0.02 * _sideM, 8.0 * _spacingM);
    const double texelM =
        std::max(_columns.spacingAt(grid.x), _rows.spacingAt(grid.y)) * _spacingM / _tile.grid().cellSide();
    double hills = reliefAt(grid, texelM) * glm::smoothstep(0.5 * onsetM, 5.0 * onsetM, distanceM);
    const glm::dvec2 place = _localFromGrid * grid;
    for (const double wave : kHillsM)
    {
        if (wave < 0.5 * _sideM) continue;
        const double amplitude = std::min(2.0 * _relief.deviationM(), 0.012 * wave);
        const double noise = _noise.sample(place.x / (4.0 * wave), place.y / (4.0 * wave)) - 0.5;
        hills += 3.0 * amplitude * noise * glm::smoothstep(0.1 * wave, wave, distanceM) *
                 (1.0 - glm::smoothstep(wave / 6.0, wave / 2.0, texelM));
    }
    return hills;
}

/// The noise of all coasts, each limited in proportion to the distance from the data, in metres. `shift`: of
/// the noise, in its periods.
double OuterGround::coastNoiseM(const glm::dvec2& place, double distanceM, double shift) const
{
    double noiseM = 0.0;
    for (const double wave : kCoastsM)
        noiseM += std::min(kSwing * wave, kSwingPerDistance * distanceM) *
                  (_noise.sample(place.x / (4.0 * wave) + shift, place.y / (4.0 * wave) - shift) - 0.5);
    return noiseM;
}

/// The border beside a place: not the nearest part of it, or coasts would run out in straight lines. They
/// wind, the more the farther out, and have bays and islands.
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
    const double dry = glm::smoothstep(0.0, 0.5, 0.5 - means.water);
    return {std::lerp(means.waterHeightM, land, dry), means.water};
}

glm::dvec3 OuterGround::position(const glm::dvec2& grid, double heightM) const
{
    const glm::dvec2 border = glm::clamp(grid, glm::dvec2(0.0), _last);
    const glm::dvec3 at = _tile.frame().positionAt(border.x, border.y, heightM);
    const glm::dvec2 plan = glm::dvec2(at) + _localFromGrid * (grid - border);
    if (_tile.frame().placement() == core::Placement::planar) return {plan, at.z};
    const double fallM =
        (glm::dot(plan, plan) - at.x * at.x - at.y * at.y) / (2.0 * foundation::kEarthRadiusM);
    return {plan, at.z - fallM};
}

} // namespace osgTerrainROAM
