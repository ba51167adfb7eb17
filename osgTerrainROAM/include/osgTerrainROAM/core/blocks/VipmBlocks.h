// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>
#include <osgTerrainROAM/core/blocks/BlockBounds.h>
#include <osgTerrainROAM/core/roam/RoamTile.h>

namespace osgTerrainROAM::core
{

/// A level of a block that is drawn: of those between, none is.
struct VipmLevel
{
    std::uint32_t steps = 0; ///< edge collapses from the finest level
    std::uint32_t triangles = 0;
    float errorM =
        0.0f; ///< no sample of the block is farther from the surface, in 3D; never less than at finer levels
};

/// The progressive mesh of one block. Its vertices are samples, in split order; those on the block's border are never removed.
struct VipmBlock
{
    osgPMObjects::core::ProgressiveMesh progressive;
    std::vector<GridPoint> places; ///< of the vertices
    std::vector<VipmLevel> levels; ///< finest first
    BlockBox box;
};

/// The progressive meshes of all blocks of a tile, with locked borders: neighbours share all samples of their border at every level, so
/// the mesh conforms whatever their levels are.
/// Levels are a ladder: each has about five sixths of the triangles of the one before. The error of each is measured over all samples of
/// the block. The ladder ends where a collapse turns a triangle over in plan, or only the border is left.
/// Frame: the tile's. Threads: const from any. Memory: memoryBytes(). Cost of making: that of simplify(), some 10 µs a sample; blocks are
/// made in parallel, with the same result.
class VipmBlocks
{
public:
    VipmBlocks(std::shared_ptr<const RoamTile> tile, const BlockGrid& grid);

    const RoamTile& tile() const { return *_tile; }
    const BlockGrid& grid() const { return _grid; }
    const VipmBlock& block(std::uint32_t block) const { return *_blocks[block]; }

    /// The same for the tile as it is now: blocks that hold points of the rectangles are made anew, the others shared.
    std::shared_ptr<const VipmBlocks> remade(std::span<const GridRect> moved) const;

    std::uint64_t revision() const { return _revision; } ///< of the tile when they were made
    std::size_t memoryBytes() const;

private:
    friend struct VipmMutation;

    void make(std::span<const std::uint32_t> blocks);

    std::shared_ptr<const RoamTile> _tile;
    BlockGrid _grid;
    std::vector<std::shared_ptr<const VipmBlock>> _blocks;
    std::uint64_t _revision = 0;
};

/// Makes the progressive mesh of one block. `locksBorder` false is for tests: the border is simplified like the rest.
VipmBlock makeVipmBlock(const PlacedTile& tile, const BlockGrid& grid, std::uint32_t block,
                        bool locksBorder = true);

} // namespace osgTerrainROAM::core
