// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cassert>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

void LeafArena::insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes)
{
    Block& block = _blocks[region];
    if (block.sizeClass == 0 || block.count == 1u << block.sizeClass)
        move(region, block.sizeClass == 0 ? kSmallestClass : block.sizeClass + 1, changes);
    const std::uint32_t slot = block.first + block.count++;
    _leaves[slot] = leaf;
    changes.triangles.push_back(slot);
    ++_leafCount;
}

void LeafArena::erase(std::uint32_t slot, MeshChanges& changes)
{
    cutOut(slot);
    closeGaps(changes);
}

void LeafArena::closeGaps(MeshChanges& changes)
{
    for (const std::uint32_t gap : _gaps)
    {
        Block& block = _blocks[regionOf(gap)];
        while (block.count > 0 && !_leaves[block.first + block.count - 1].exists())
            --block.count;
        if (gap >= block.first + block.count) continue; // was at the end
        _leaves[gap] = _leaves[block.first + --block.count];
        changes.triangles.push_back(gap);
    }
    _leafCount -= static_cast<std::uint32_t>(_gaps.size());
    // Not before all are closed: a block that moves takes its leaves along, not its gaps.
    std::uint32_t last = kNone;
    for (const std::uint32_t gap : _gaps)
        if (const std::uint32_t region = regionOf(gap); region != last) shrink(last = region, changes);
    _gaps.clear();
}

void LeafArena::replace(std::uint32_t slot, TriangleId leaf, MeshChanges& changes)
{
    _leaves[slot] = leaf;
    changes.triangles.push_back(slot);
}

void LeafArena::shrink(std::uint32_t region, MeshChanges& changes)
{
    Block& block = _blocks[region];
    if (block.sizeClass == 0 || block.count > 1u << block.sizeClass >> 2) return;
    if (block.count == 0)
    {
        freeBlock(block.first, block.sizeClass);
        block = {};
        return;
    }
    std::uint32_t sizeClass = block.sizeClass;
    while (sizeClass > kSmallestClass && block.count <= 1u << sizeClass >> 2)
        --sizeClass;
    if (sizeClass < block.sizeClass) move(region, sizeClass, changes);
}

/// Gives a region's block another size.
void LeafArena::move(std::uint32_t region, std::uint32_t sizeClass, MeshChanges& changes)
{
    Block& block = _blocks[region];
    const Block old = block;
    block.sizeClass = sizeClass;
    block.first = takeBlock(sizeClass);
    for (std::uint32_t slot = block.first; slot < block.first + (1u << sizeClass); slot += kSmallest)
        _regionOfGroup[slot / kSmallest] = static_cast<std::uint16_t>(region);
    for (std::uint32_t i = 0; i < old.count; ++i)
    {
        _leaves[block.first + i] = _leaves[old.first + i];
        changes.triangles.push_back(block.first + i);
    }
    if (old.sizeClass != 0) freeBlock(old.first, old.sizeClass);
}

/// The smallest free block that is large enough, halved until it fits; else new slots at the end.
std::uint32_t LeafArena::takeBlock(std::uint32_t sizeClass)
{
    std::uint32_t larger = sizeClass;
    while (larger < _freeBlocks.size() && _freeBlocks[larger].empty())
        ++larger;
    if (larger < _freeBlocks.size())
    {
        const std::uint32_t first = *_freeBlocks[larger].begin();
        _freeBlocks[larger].erase(_freeBlocks[larger].begin());
        while (larger > sizeClass)
        {
            --larger;
            _freeBlocks[larger].insert(first + (1u << larger));
        }
        return first;
    }
    // Blocks lie at multiples of their size: what that leaves out is free, too.
    const std::uint32_t size = 1u << sizeClass;
    while (slotCount() % size != 0)
    {
        const auto gap = static_cast<std::uint32_t>(std::countr_zero(slotCount()));
        const std::uint32_t first = slotCount();
        addSlots(1u << gap);
        freeBlock(first, gap);
    }
    const std::uint32_t first = slotCount();
    addSlots(size);
    return first;
}

void LeafArena::addSlots(std::uint32_t count)
{
    for (std::uint32_t i = 0; i < count; ++i)
        appendTightly(_leaves);
    _regionOfGroup.resize(_leaves.size() / kSmallest);
}

void LeafArena::freeBlock(std::uint32_t first, std::uint32_t sizeClass)
{
    for (;; ++sizeClass)
    {
        const std::uint32_t buddy = first ^ (1u << sizeClass);
        if (_freeBlocks[sizeClass].erase(buddy) == 0) break;
        first = std::min(first, buddy);
    }
    _freeBlocks[sizeClass].insert(first);
}

std::size_t LeafArena::memoryBytes() const
{
    std::size_t bytes = _leaves.capacity() * sizeof(TriangleId) +
                        _regionOfGroup.capacity() * sizeof(std::uint16_t) +
                        _gaps.capacity() * sizeof(std::uint32_t) + _blocks.capacity() * sizeof(Block);
    constexpr std::size_t kNodeBytes = 48; // of a set, with what the heap adds
    for (const auto& free : _freeBlocks)
        bytes += free.size() * kNodeBytes;
    return bytes;
}

bool LeafArena::isConsistent() const
{
    std::size_t leaves = 0;
    std::vector<bool> used(_leaves.size(), false);
    for (const Block& block : _blocks)
    {
        if (block.sizeClass == 0) continue;
        if (block.count > 1u << block.sizeClass) return false;
        leaves += block.count;
        for (std::uint32_t i = 0; i < 1u << block.sizeClass; ++i)
        {
            const std::uint32_t slot = block.first + i;
            if (slot >= used.size() || used[slot]) return false; // blocks overlap
            used[slot] = true;
        }
    }
    for (std::size_t sizeClass = 0; sizeClass < _freeBlocks.size(); ++sizeClass)
        for (const std::uint32_t first : _freeBlocks[sizeClass])
            for (std::uint32_t i = 0; i < 1u << sizeClass; ++i)
            {
                if (first + i >= used.size() || used[first + i]) return false;
                used[first + i] = true;
            }
    return leaves == _leafCount && std::all_of(used.begin(), used.end(), [](bool isUsed) { return isUsed; });
}

} // namespace osgTerrainROAM::core
