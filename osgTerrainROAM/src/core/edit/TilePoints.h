// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// What a tile keeps of a vertex in its table, in its sheets or beyond its data.
struct PointState
{
    GridPoint place;
    SampleTable::Sample bound{}; ///< in the table of the raster, or beyond the data
    SampleTable::Sample inSheet{};
    bool isElsewhere = false; ///< its data are among the fine samples
    bool isLoose = false;     ///< RoamTile::setLoose()
};

/// A square of fine samples.
struct ChunkState
{
    static constexpr std::size_t kPoints = FineSamples::kChunkSide * FineSamples::kChunkSide;

    GridPoint place; ///< of its south-western point
    std::array<SampleTable::Sample, kPoints> samples = emptySamples();

    static bool isKept(const SampleTable::Sample& sample)
    {
        return !std::isnan(sample.heightM) || sample.errorM > 0.0f;
    }
    bool isWithin(const TileGrid& grid) const;

private:
    static std::array<SampleTable::Sample, kPoints> emptySamples();
};

/// The vertices outside the fine samples whose state is no longer that of `before`, by rows.
std::vector<PointState> changedPoints(const RoamTile& before, const RoamTile& edited);

/// All fine samples of a tile, by rows of chunks.
std::vector<ChunkState> chunksOf(const RoamTile& edited);

/// Tells whether a point is one of the bintree's.
bool isInTree(const RoamTile& tile, GridPoint place);

void restorePoints(RoamTile& tile, std::span<const PointState> points);
void restoreChunk(RoamTile& tile, const ChunkState& chunk);

/// A mark of a tile's grid, frame, heights and bounds.
std::uint64_t markOfTile(const RoamTile& tile);

} // namespace osgTerrainROAM::core
