// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cassert>
#include <utility>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

namespace
{
constexpr std::uint32_t kSmallestClass = 5; // 32 leaves: two cache lines of owners, six of triangles
}

LeafArena::LeafArena(std::uint32_t regions) : _blocks(regions) {}

void LeafArena::insert(NodeIndex owner, std::uint32_t region, const LeafTriangle& triangle,
                       MeshChanges& changes)
{
    Block& block = _blocks[region];
    if (block.sizeClass == 0 || block.count == 1u << block.sizeClass) grow(block, changes);
    const std::uint32_t slot = block.first + block.count++;
    _triangles[slot] = triangle;
    _ownerOfSlot[slot] = owner;
    if (owner >= _slotOfNode.size())
        _slotOfNode.resize(std::max<std::size_t>(owner + 1, 2 * _slotOfNode.size()), kNone);
    _slotOfNode[owner] = slot;
    changes.triangles.push_back(slot);
    ++_leafCount;
}

void LeafArena::erase(NodeIndex owner, std::uint32_t region, MeshChanges& changes)
{
    Block& block = _blocks[region];
    const std::uint32_t slot = _slotOfNode[owner];
    const std::uint32_t last = block.first + --block.count;
    assert(slot >= block.first && slot <= last);
    if (slot != last)
    {
        _triangles[slot] = _triangles[last];
        _ownerOfSlot[slot] = _ownerOfSlot[last];
        _slotOfNode[_ownerOfSlot[slot]] = slot;
        changes.triangles.push_back(slot);
    }
    _slotOfNode[owner] = kNone;
    --_leafCount;
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
        const std::uint32_t slot = block.first + i;
        _triangles[slot] = _triangles[old.first + i];
        _ownerOfSlot[slot] = _ownerOfSlot[old.first + i];
        _slotOfNode[_ownerOfSlot[slot]] = slot;
        changes.triangles.push_back(slot);
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
    const auto first = static_cast<std::uint32_t>(_triangles.size());
    _triangles.resize(_triangles.size() + (std::size_t{1} << sizeClass));
    _ownerOfSlot.resize(_triangles.size(), kNone);
    return first;
}

bool LeafArena::isConsistent() const
{
    std::size_t leaves = 0;
    std::vector<bool> used(_triangles.size(), false);
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
            if (i < block.count && _slotOfNode[_ownerOfSlot[slot]] != slot) return false;
        }
    }
    return leaves == _leafCount;
}

} // namespace osgTerrainROAM::core
