// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <utility>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

namespace
{

std::uint64_t bit(std::uint32_t place)
{
    return std::uint64_t{1} << place;
}

} // namespace

void LeafArena::insert(TriangleId leaf, std::uint32_t region, MeshChanges& changes)
{
    ++_leafCount;
    std::uint32_t index = _firstArena[region];
    if (index == kNone)
    {
        index = addArena(region, kNone, SlotBlocks::kSmallestClass);
        return lay(index, {&leaf, 1}, true, changes);
    }
    while (_arenas[index].count() == _arenas[index].slots() && _arenas[index].next != kNone)
        index = _arenas[index].next;
    Arena& arena = _arenas[index];
    if (arena.count() == arena.slots())
    {
        _taken.clear();
        takeUp(arena);
        _taken.push_back(leaf);
        return layInMore(index, changes);
    }
    const auto gap = static_cast<std::uint32_t>(std::countr_one(arena.used));
    replace(arena.first + gap, leaf, changes);
    arena.used |= bit(gap);
}

void LeafArena::erase(std::uint32_t slot, MeshChanges& changes)
{
    cutOut(slot);
    closeGaps(changes);
}

void LeafArena::split(std::uint32_t slot, TriangleId earlier, TriangleId later, MeshChanges& changes)
{
    ++_leafCount;
    const std::uint32_t index = arenaAt(slot);
    Arena& arena = _arenas[index];
    const std::uint32_t place = slot - arena.first, last = arena.slots() - 1;
    // The number of leaves between it and the nearest gap, on either side; there is no gap beyond the arena's
    // ends.
    const auto after = static_cast<std::uint32_t>(std::countr_one(arena.used >> place)) - 1;
    const auto before = static_cast<std::uint32_t>(std::countl_one(arena.used << (63 - place))) - 1;
    const bool isAfter = place + after < last && (after <= before || before == place);
    if (!isAfter && before == place)
    {
        _taken.clear();
        takeUp(arena); // it is full
        const auto taken = _taken.begin() + place;
        *taken = earlier;
        _taken.insert(taken + 1, later);
        return layInMore(index, changes);
    }
    const std::uint32_t gap = isAfter ? slot + after + 1 : slot - before - 1;
    const std::uint32_t beside = !_isInOrder ? gap : isAfter ? slot + 1 : slot - 1;
    if (_isInOrder) shift(slot, gap, changes);
    replace(isAfter ? slot : beside, earlier, changes);
    replace(isAfter ? beside : slot, later, changes);
    arena.used |= bit(gap - arena.first);
}

/// Moves the leaves between a slot and a gap, on either side, by one into the gap.
void LeafArena::shift(std::uint32_t slot, std::uint32_t gap, MeshChanges& changes)
{
    for (; gap > slot + 1; --gap)
        replace(gap, _leaves[gap - 1], changes);
    for (; gap + 1 < slot; ++gap)
        replace(gap, _leaves[gap + 1], changes);
}

/// Frees empty arenas first: their slots are not written, so no other arena may join them.
void LeafArena::closeGaps(MeshChanges& changes)
{
    for (const std::uint32_t index : _touched)
    {
        Arena& arena = _arenas[index];
        std::uint64_t cut = std::exchange(arena.cut, 0);
        if (arena.used == 0)
        {
            removeArena(index);
            continue;
        }
        for (; cut != 0; cut &= cut - 1)
            changes.triangles.push_back(arena.first + static_cast<std::uint32_t>(std::countr_zero(cut)));
    }
    for (const std::uint32_t index : _touched)
        if (_arenas[index].region != kNone) settle(index, changes);
    _touched.clear();
}

std::uint32_t LeafArena::appendRanges(std::uint32_t region, std::vector<TriangleRange>& ranges) const
{
    const std::size_t before = ranges.size();
    std::uint32_t leaves = 0;
    for (std::uint32_t index = _firstArena[region]; index != kNone; index = _arenas[index].next)
    {
        const Arena& arena = _arenas[index];
        leaves += arena.count();
        if (ranges.size() > before && ranges.back().first + ranges.back().count == arena.first)
            ranges.back().count += drawnSlots(arena);
        else
            ranges.push_back({arena.first, drawnSlots(arena)});
    }
    return leaves;
}

std::size_t LeafArena::memoryBytes() const
{
    std::size_t bytes = _leaves.capacity() * sizeof(TriangleId) + _arenas.capacity() * sizeof(Arena) +
                        _taken.capacity() * sizeof(TriangleId) + _blocks.memoryBytes();
    for (const auto* indices : {&_arenaOfGroup, &_freeArenas, &_firstArena, &_touched})
        bytes += indices->capacity() * sizeof(std::uint32_t);
    return bytes;
}

} // namespace osgTerrainROAM::core
