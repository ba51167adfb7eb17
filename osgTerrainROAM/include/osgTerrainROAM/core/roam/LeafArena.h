// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Which leaf has which slot of the index buffer. Every region of the tree keeps its leaves together, so that a draw call
/// can leave out the regions that no camera sees. Inserting takes the next slot of the leaf's region, erasing moves the
/// region's last leaf into the gap: a change touches two slots.
/// A region that outgrows its block moves to one of twice the size; blocks are powers of two on free lists.
/// Who inserts and erases keeps the slots of the leaves, and is told which to note again.
/// Invariant: isConsistent(). Memory: 4 B per slot.
/// Source: terrain anchors, point 4 (stable slots, swap with the last).
class LeafArena
{
public:
    explicit LeafArena(std::uint32_t regions) : _blocks(regions) {}

    /// Returns the slots to note: the new leaf's own, the last of them, and when the block has moved all of its leaves'.
    TriangleRange insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes);

    /// Returns the slot to note, if a leaf has moved into the gap.
    TriangleRange erase(std::uint32_t slot, std::uint32_t region, MeshChanges& changes);

    /// Gives a slot to another leaf of the same region.
    void replace(std::uint32_t slot, TriangleId leaf, MeshChanges& changes);

    /// Erases all leaves of a region, whatever their number, in one step; its block is free. Returns their number.
    std::uint32_t clear(std::uint32_t region);

    TriangleId leaf(std::uint32_t slot) const { return _leaves[slot]; }
    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(_leaves.size()); }
    TriangleRange region(std::uint32_t index) const { return {_blocks[index].first, _blocks[index].count}; }
    std::uint32_t regionCount() const { return static_cast<std::uint32_t>(_blocks.size()); }
    std::uint32_t leafCount() const { return _leafCount; }
    std::size_t memoryBytes() const;
    bool isConsistent() const;

private:
    struct Block
    {
        std::uint32_t first = 0;
        std::uint32_t count = 0;
        std::uint32_t sizeClass = 0; ///< capacity 2^sizeClass; 0: no block yet
    };

    void grow(Block& block, MeshChanges& changes);
    std::uint32_t takeBlock(std::uint32_t sizeClass);

    std::vector<TriangleId> _leaves; ///< by slot
    std::vector<Block> _blocks;
    std::array<std::vector<std::uint32_t>, 32> _freeBlocks;
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
