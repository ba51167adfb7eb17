// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// Which leaf has which slot of the index buffer. Every region of the tree keeps its leaves together, so that a draw call
/// can leave out the regions that no camera sees. Inserting takes the next slot of the leaf's region, erasing moves the
/// region's last leaf into the gap: a change touches two slots.
/// A region's block has a power of two of slots. One that is full moves to twice its size, one that is down to a quarter
/// to half; free blocks join with their neighbours (buddies).
/// Who inserts and erases keeps the slots of the leaves, and has to note again those that are written to the changes.
/// Invariant: isConsistent(). Memory: 4.5 B per slot.
/// Source: terrain anchors, point 4 (stable slots, swap with the last); Knuth, TAOCP 1, §2.5 (buddies).
class LeafArena
{
public:
    explicit LeafArena(std::uint32_t regions) : _blocks(regions) {}

    void insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes);
    void erase(std::uint32_t slot, MeshChanges& changes);

    /// Erases many leaves: first all are cut out, then the gaps are closed, so that no leaf moves that goes as well.
    void cutOut(std::uint32_t slot)
    {
        _leaves[slot] = {};
        _gaps.push_back(slot);
    }
    void closeGaps(MeshChanges& changes);

    /// Gives a slot to another leaf of the same region.
    void replace(std::uint32_t slot, TriangleId leaf, MeshChanges& changes);

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

    static constexpr std::uint32_t kSmallestClass = 2, kSmallest = 1u << kSmallestClass;

    std::uint32_t regionOf(std::uint32_t slot) const { return _regionOfGroup[slot / kSmallest]; }
    void shrink(std::uint32_t region, MeshChanges& changes);
    void move(std::uint32_t region, std::uint32_t sizeClass, MeshChanges& changes);
    std::uint32_t takeBlock(std::uint32_t sizeClass);
    void addSlots(std::uint32_t count);
    void freeBlock(std::uint32_t first, std::uint32_t sizeClass);

    std::vector<TriangleId> _leaves;                     ///< by slot
    std::vector<std::uint16_t> _regionOfGroup;           ///< of kSmallest slots, the smallest block
    std::vector<Block> _blocks;                          ///< by region
    std::array<std::set<std::uint32_t>, 32> _freeBlocks; ///< first slots, by size class
    std::vector<std::uint32_t> _gaps;                    ///< slots, between cutOut() and closeGaps()
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
