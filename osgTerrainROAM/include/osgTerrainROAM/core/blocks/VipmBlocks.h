// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgTerrainROAM/core/blocks/BlockBounds.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// What becomes of the border of a block of progressive meshes.
enum class VipmBorders
{
    locked, ///< all its samples stay: neighbours share them, and the mesh conforms
    /// it is simplified along its sides; a rim (BlockRim) goes under the neighbours, and the blocks cover
    /// each other
    overlapping,
};

/// A level of a block that is drawn: of those between, none is.
struct VipmLevel
{
    std::uint32_t steps = 0;     ///< edge collapses from the finest level
    std::uint32_t triangles = 0; ///< those of the rim included
    float errorM =
        0.0f; ///< no sample of the block is farther from the surface, in 3D; never less than at finer levels
};

/// The progressive mesh of one block. Its vertices are samples, in split order. The sides of the border stay
/// where they are in plan.
struct VipmBlock
{
    osgPMObjects::core::ProgressiveMesh progressive;
    std::vector<GridPoint> places; ///< of the vertices
    std::vector<VipmLevel> levels; ///< finest first
    BlockBox box;
};

/// The progressive meshes of all blocks of a tile, with locked or overlapping borders. Levels are a ladder:
/// each has about five sixths of the triangles of the one before. The error of each is measured over all
/// samples of the block. The ladder ends where a collapse turns a triangle over in plan, or nothing is left
/// to remove.
/// Frame: the tile's. Threads: const from any. Memory: memoryBytes(). Cost of making: that of simplify(),
/// some 10 µs a sample; blocks are made in parallel, with the same result.
class VipmBlocks
{
public:
    VipmBlocks(std::shared_ptr<const RoamTile> tile, const BlockGrid& grid,
               VipmBorders borders = VipmBorders::locked);

    const RoamTile& tile() const { return *_tile; }
    const BlockGrid& grid() const { return _grid; }
    VipmBorders borders() const { return _borders; }
    const VipmBlock& block(std::uint32_t block) const { return *_blocks[block]; }

    /// The height in the tile's frame at which the outer edge of a block's rim lies: below all samples of the
    /// blocks around it. Units: metres.
    double rimHeightM(std::uint32_t block) const { return _rimHeightsM[block]; }

    /// The same for the tile as it is now: blocks that hold points of the rectangles are made anew, the
    /// others shared.
    std::shared_ptr<const VipmBlocks> remade(std::span<const GridRect> moved) const;

    std::uint64_t revision() const { return _revision; } ///< of the tile when they were made
    std::size_t memoryBytes() const;

private:
    friend struct VipmMutation;

    void make(std::span<const std::uint32_t> blocks);
    double heightOfRimM(std::uint32_t block) const;

    std::shared_ptr<const RoamTile> _tile;
    BlockGrid _grid;
    VipmBorders _borders;
    std::vector<std::shared_ptr<const VipmBlock>> _blocks;
    std::vector<double> _rimHeightsM; ///< by block
    std::uint64_t _revision = 0;
};

/// Makes the progressive mesh of one block. Nothing for the borders: they are simplified like the rest, for
/// tests.
VipmBlock makeVipmBlock(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t block,
                        std::optional<VipmBorders> borders);

} // namespace osgTerrainROAM::core
