// SPDX-License-Identifier: Apache-2.0
#include "ElevationSamples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "../core/heightfield/VoidFill.h"

namespace osgTerrainROAM
{

namespace
{

/// Samples a side of a tile without elevation layer: enough for the Earth's curvature.
constexpr int kFlatSide = 65;

/// Larger numbers are no heights in any unit: they stand for voids where no ValidDataOperator marks them.
constexpr float kMostHeight = 1e9f;

float sampleOf(const osgTerrain::Layer& layer, int column, int row)
{
    float value = 0.0f;
    const bool valid =
        layer.getValidValue(static_cast<unsigned int>(column), static_cast<unsigned int>(row), value);
    return valid && std::abs(value) < kMostHeight ? value : std::numeric_limits<float>::quiet_NaN();
}

bool hasValidNeighbour(const ElevationSamples& samples, int column, int row)
{
    for (int r = std::max(row - 1, 0); r <= std::min(row + 1, samples.rows - 1); ++r)
        for (int c = std::max(column - 1, 0); c <= std::min(column + 1, samples.columns - 1); ++c)
            if (!samples.voidAt(c, r)) return true;
    return false;
}

/// TerrainTile::setTreatBoundariesToValidDataAsDefaultValue(): the rim of a void gets the layer's default.
void fillRims(ElevationSamples& samples, float value)
{
    std::vector<bool> isVoid = samples.isVoid;
    for (int row = 0; row < samples.rows; ++row)
        for (int column = 0; column < samples.columns; ++column)
            if (samples.voidAt(column, row) && hasValidNeighbour(samples, column, row))
            {
                const std::size_t at = static_cast<std::size_t>(row) * samples.columns + column;
                samples.heights[at] = value;
                isVoid[at] = false;
            }
    samples.isVoid = std::move(isVoid);
}

} // namespace

std::optional<ElevationSamples> elevationSamples(const osgTerrain::TerrainTile& tile)
{
    ElevationSamples samples;
    const osgTerrain::Layer* layer = tile.getElevationLayer();
    samples.columns = layer ? static_cast<int>(layer->getNumColumns()) : kFlatSide;
    samples.rows = layer ? static_cast<int>(layer->getNumRows()) : kFlatSide;
    if (samples.columns < 2 || samples.rows < 2) return std::nullopt;
    samples.heights.reserve(static_cast<std::size_t>(samples.columns) * samples.rows);
    for (int row = 0; row < samples.rows; ++row)
        for (int column = 0; column < samples.columns; ++column)
            samples.heights.push_back(layer ? sampleOf(*layer, column, row) : 0.0f);

    const auto isNan = [](float height) { return std::isnan(height); };
    if (std::none_of(samples.heights.begin(), samples.heights.end(), isNan)) return samples;
    if (std::all_of(samples.heights.begin(), samples.heights.end(), isNan)) return std::nullopt;
    std::transform(samples.heights.begin(), samples.heights.end(), std::back_inserter(samples.isVoid), isNan);
    if (tile.getTreatBoundariesToValidDataAsDefaultValue()) fillRims(samples, layer->getDefaultValue().x());
    core::fillVoids(samples.heights, samples.columns, samples.rows);
    return samples;
}

} // namespace osgTerrainROAM
