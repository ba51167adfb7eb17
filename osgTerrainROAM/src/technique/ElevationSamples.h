// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <osgTerrain/TerrainTile>

namespace osgTerrainROAM
{

/// The elevation layer of a tile, complete. Row 0 is the layer's first. Units: the layer's.
struct ElevationSamples
{
    int columns = 0, rows = 0;
    std::vector<float> heights; ///< row by row; where there is none, a smooth surface through the rim
    std::vector<bool> isVoid;   ///< empty: none is

    bool voidAt(int column, int row) const
    {
        return !isVoid.empty() && isVoid[static_cast<std::size_t>(row) * columns + column];
    }
};

/// Reads a layer of any kind sample by sample; samples that its ValidDataOperator refuses are void. A tile
/// without an elevation layer is flat. Empty: fewer than two columns or rows, or no height at all.
std::optional<ElevationSamples> elevationSamples(const osgTerrain::TerrainTile& tile);

} // namespace osgTerrainROAM
