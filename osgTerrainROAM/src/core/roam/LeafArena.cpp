// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

namespace
{
constexpr std::uint32_t kSmallestClass = 4; // 16 leaves: one cache line
}

TriangleRange LeafArena::insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes)
{
    Block& block = _blocks[region];
    const bool full = block.sizeClass == 0 || block.count == 1u << block.sizeClass;
    if (full) grow(block, changes);
    const std::uint32_t slot = block.first + block.count++;
    _leaves[slot] = leaf;
    changes.triangles.push_back(slot);
    ++_leafCount;
    return full ? TriangleRange{block.first, block.count} : TriangleRange{slot, 1};
}

TriangleRange LeafArena::erase(std::uint32_t slot, std::uint32_t region, MeshChanges& changes)
{
    Block& block = _blocks[region];
    const std::uint32_t last = block.first + --block.count;
    assert(slot >= block.first && slot <= last);
    --_leafCount;
    if (slot == last) return {};
    _leaves[slot] = _leaves[last];
    changes.triangles.push_back(slot);
    return {slot, 1};
}

void LeafArena::replace(std::uint32_t slot, TriangleId leaf, MeshChanges& changes)
{
    _leaves[slot] = leaf;
    changes.triangles.push_back(slot);
}

std::uint32_t LeafArena::clear(std::uint32_t region)
{
    const Block old = std::exchange(_blocks[region], Block{});
    if (old.sizeClass != 0) _freeBlocks[old.sizeClass].push_back(old.first);
    _leafCount -= old.count;
    return old.count;
}

void LeafArena::grow(Block& block, MeshChanges& changes)
{
    const Block old = block;
    block.sizeClass = old.sizeClass == 0 ? kSmallestClass : old.sizeClass + 1;
    block.first = takeBlock(block.sizeClass);
    for (std::uint32_t i = 0; i < old.count; ++i)
    {
        _leaves[block.first + i] = _leaves[old.first + i];
        changes.triangles.push_back(block.first + i);
    }
    if (old.sizeClass != 0) _freeBlocks[old.sizeClass].push_back(old.first);
}

std::uint32_t LeafArena::takeBlock(std::uint32_t sizeClass)
{
    auto& free = _freeBlocks[sizeClass];
    if (!free.empty())
    {
        const std::uint32_t first = free.back();
        free.pop_back();
        return first;
    }
    const std::uint32_t first = slotCount();
    _leaves.resize(_leaves.size() + (std::size_t{1} << sizeClass));
    return first;
}

std::size_t LeafArena::memoryBytes() const
{
    std::size_t bytes = _leaves.capacity() * sizeof(TriangleId) + _blocks.capacity() * sizeof(Block);
    for (const auto& free : _freeBlocks)
        bytes += free.capacity() * sizeof(std::uint32_t);
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
    return leaves == _leafCount;
}

} // namespace osgTerrainROAM::core
