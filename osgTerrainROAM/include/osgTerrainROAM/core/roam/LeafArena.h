// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The leaves of the mesh as one index array in which every region of the tree keeps its leaves together, so
/// that a draw call can leave out the regions that no camera sees. A leaf has a slot; inserting takes the next
/// slot of its region, erasing moves the region's last leaf into the gap: a change touches two slots.
/// A region that outgrows its block moves to one of twice the size; blocks are powers of two on free lists.
/// Invariant: isConsistent(). Memory: 12 B per slot, 4 B per slot and per node for the two maps.
/// Source: terrain anchors, point 4 (stable slots, swap with the last).
class LeafArena
{
public:
    explicit LeafArena(std::uint32_t regions);

    void insert(NodeIndex owner, std::uint32_t region, const LeafTriangle& triangle, MeshChanges& changes);
    void erase(NodeIndex owner, std::uint32_t region, MeshChanges& changes);

    /// Erases all leaves of a region, whatever their number, in one step; its block is free. Returns their number.
    std::uint32_t clear(std::uint32_t region);

    std::span<const LeafTriangle> triangles() const { return _triangles; }
    TriangleRange region(std::uint32_t index) const { return {_blocks[index].first, _blocks[index].count}; }
    std::uint32_t regionCount() const { return static_cast<std::uint32_t>(_blocks.size()); }
    std::uint32_t leafCount() const { return _leafCount; }
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

    std::vector<LeafTriangle> _triangles;
    std::vector<NodeIndex> _ownerOfSlot;
    std::vector<std::uint32_t> _slotOfNode;
    std::vector<Block> _blocks;
    std::array<std::vector<std::uint32_t>, 32> _freeBlocks;
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
