// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>
#include <osgTerrainROAM/core/roam/SlotBlocks.h>

namespace osgTerrainROAM::core
{

/// The placement of leaves in the arenas of their region.
enum class LeafPlacement
{
    inOrder, ///< in that of the bintree: long strips, few vertices transformed
    nearby,  ///< where there is a gap close by: fewer slots are written
};

/// The table of the leaves by their slots in the index buffer. Every region of the tree keeps its leaves in
/// arenas of up to 64 slots, so that a draw call can omit the regions that no camera sees. Within a region
/// they lie in the order of the bintree, so that each leaf shares an edge with the one before. Arenas have
/// gaps, drawn as triangles without extent. When a leaf splits, its two halves take its slot and the nearest
/// gap of the arena, and those between move up by one. A full arena moves to twice its size; an arena of 64
/// slots gives half of its leaves to a new one behind it. Each half is spread evenly. An arena with few
/// leaves joins a neighbour, or moves to half its size. LeafPlacement::nearby neither moves nor spreads
/// leaves: the gaps are at the arena's end. The caller of split, insert and erase keeps the slots of the
/// leaves, and has to read again those in the changes.
/// Invariant: isConsistent(). Memory: 6 B per slot.
/// Source: Bayer & McCreight, *Organization and maintenance of large ordered indexes*, 1972 (leaves of a
/// B-tree split and join); Itai, Konheim & Rodeh, *A sparse table implementation of priority queues*, 1981
/// (gaps in an ordered array). See docs/decisions/0011.
class LeafArena
{
public:
    explicit LeafArena(std::uint32_t regions, LeafPlacement placement = LeafPlacement::inOrder)
        : _isInOrder(placement == LeafPlacement::inOrder), _firstArena(regions, kNone)
    {
    }

    /// Inserts anywhere in the region; in order if the region was empty.
    void insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes);
    void erase(std::uint32_t slot, MeshChanges& changes);

    /// Replaces one leaf by two, in their order.
    void split(std::uint32_t slot, TriangleId earlier, TriangleId later, MeshChanges& changes);

    /// Gives a slot to another leaf of the same region.
    void replace(std::uint32_t slot, TriangleId leaf, MeshChanges& changes)
    {
        _leaves[slot] = leaf;
        changes.triangles.push_back(slot);
    }

    /// Erase many leaves: cutOut() each, then fillGap() for each new leaf of the same region, then
    /// closeGaps(). No leaf moves before closeGaps().
    void cutOut(std::uint32_t slot)
    {
        const std::uint32_t index = arenaAt(slot);
        Arena& arena = _arenas[index];
        if (arena.cut == 0) _touched.push_back(index);
        arena.cut |= arena.bitOf(slot);
        arena.used &= ~arena.bitOf(slot);
        _leaves[slot] = {};
        --_leafCount;
    }
    void fillGap(std::uint32_t slot, TriangleId leaf)
    {
        Arena& arena = _arenas[arenaAt(slot)];
        arena.used |= arena.bitOf(slot);
        _leaves[slot] = leaf;
        ++_leafCount;
    }
    void closeGaps(MeshChanges& changes);

    TriangleId leaf(std::uint32_t slot) const { return _leaves[slot]; } ///< none: a gap
    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(_leaves.size()); }
    std::uint32_t leafCount() const { return _leafCount; }
    std::uint32_t regionCount() const { return static_cast<std::uint32_t>(_firstArena.size()); }
    std::uint32_t regionOf(std::uint32_t slot) const { return _arenas[arenaAt(slot)].region; }

    /// Appends the slots to draw for a region, gaps included, in its order. Returns the number of leaves in
    /// it.
    std::uint32_t appendRanges(std::uint32_t region, std::vector<TriangleRange>& ranges) const;

    /// Calls visit(leaf) for the leaves of a region, in its order.
    template<class Visit>
    void forEachLeaf(std::uint32_t region, const Visit& visit) const
    {
        for (std::uint32_t index = _firstArena[region]; index != kNone; index = _arenas[index].next)
            for (std::uint64_t left = _arenas[index].used; left != 0; left &= left - 1)
                visit(_leaves[_arenas[index].first + static_cast<std::uint32_t>(std::countr_zero(left))]);
    }

    std::size_t memoryBytes() const;
    bool isConsistent() const; // LeafArenaCheck.cpp

private:
    struct Arena
    {
        std::uint64_t used = 0;       ///< by slot from the first: 1 where there is a leaf
        std::uint64_t cut = 0;        ///< likewise, between cutOut() and closeGaps(): where one was cut out
        std::uint32_t first = 0;      ///< slot
        std::uint32_t sizeClass = 0;  ///< 2^sizeClass slots
        std::uint32_t region = kNone; ///< none: the arena is free
        std::uint32_t previous = kNone, next = kNone; ///< arenas of the region, in order

        std::uint32_t slots() const { return 1u << sizeClass; }
        std::uint32_t count() const { return static_cast<std::uint32_t>(std::popcount(used)); }
        std::uint64_t bitOf(std::uint32_t slot) const { return std::uint64_t{1} << (slot - first); }
    };

    std::uint32_t arenaAt(std::uint32_t slot) const { return _arenaOfGroup[slot / SlotBlocks::kSmallest]; }
    std::uint32_t drawnSlots(const Arena& arena) const
    {
        return _isInOrder ? arena.slots() : static_cast<std::uint32_t>(std::bit_width(arena.used));
    }
    void shift(std::uint32_t slot, std::uint32_t gap, MeshChanges& changes);
    void takeUp(const Arena& arena);
    void layInMore(std::uint32_t index, MeshChanges& changes);
    void lay(std::uint32_t index, std::span<const TriangleId> leaves, bool isFresh, MeshChanges& changes);
    void settle(std::uint32_t index, MeshChanges& changes);
    bool join(std::uint32_t earlier, std::uint32_t later, MeshChanges& changes);
    std::uint32_t addArena(std::uint32_t region, std::uint32_t previous, std::uint32_t sizeClass);
    void removeArena(std::uint32_t index);
    void takeSlots(std::uint32_t index, std::uint32_t sizeClass);
    void giveSlots(std::uint32_t index);
    bool isSound(std::uint32_t index) const; // LeafArenaCheck.cpp

    bool _isInOrder;
    std::vector<TriangleId> _leaves;          ///< by slot
    std::vector<std::uint32_t> _arenaOfGroup; ///< of the smallest block's slots
    std::vector<Arena> _arenas;
    std::vector<std::uint32_t> _freeArenas;
    std::vector<std::uint32_t> _firstArena; ///< by region
    SlotBlocks _blocks;
    std::vector<std::uint32_t> _touched; ///< arenas that leaves were cut out of, until closeGaps()
    std::vector<TriangleId> _taken;      ///< leaves on their way to where they are laid
    std::uint32_t _leafCount = 0;
};

} // namespace osgTerrainROAM::core
