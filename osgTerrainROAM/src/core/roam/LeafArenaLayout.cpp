// SPDX-License-Identifier: Apache-2.0
// The layout of a region's arenas: how they grow, split, join and shrink, and where their leaves lie.
// Source: Bayer & McCreight, *Organization and maintenance of large ordered indexes*, 1972 (the leaves of a
// B-tree).
// Differs: there is no tree above them, because a leaf's slot leads to its arena.
#include <algorithm>
#include <bit>
#include <utility>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

namespace
{

/// In eighths of an arena's slots: the number of leaves at which it shrinks or joins, and the most that two
/// joined may have.
constexpr std::uint32_t kFew = 3, kMany = 6;

} // namespace

/// Takes an arena's leaves out, to be laid elsewhere.
void LeafArena::takeUp(const Arena& arena)
{
    for (std::uint64_t left = arena.used; left != 0; left &= left - 1)
        _taken.push_back(_leaves[arena.first + static_cast<std::uint32_t>(std::countr_zero(left))]);
}

/// Lays the leaves of a full arena, and one more, in new arenas.
void LeafArena::layInMore(std::uint32_t index, MeshChanges& changes)
{
    const std::span<const TriangleId> leaves(_taken);
    const std::uint32_t sizeClass = _arenas[index].sizeClass;
    if (sizeClass < SlotBlocks::kLargestClass)
    {
        giveSlots(index);
        takeSlots(index, sizeClass + 1);
        return lay(index, leaves, true, changes);
    }
    const std::uint32_t behind = addArena(_arenas[index].region, index, sizeClass);
    lay(index, leaves.first(leaves.size() / 2), false, changes);
    lay(behind, leaves.subspan(leaves.size() / 2), true, changes);
}

/// Writes an arena's leaves in order, evenly spread. New slots have to be written even where they are gaps.
void LeafArena::lay(std::uint32_t index, std::span<const TriangleId> leaves, bool isFresh,
                    MeshChanges& changes)
{
    Arena& arena = _arenas[index];
    const auto count = static_cast<std::uint32_t>(leaves.size());
    const std::uint32_t over = _isInOrder ? arena.slots() : count;
    arena.used = 0;
    std::uint32_t next = 0;
    for (std::uint32_t i = 0; i < arena.slots(); ++i)
    {
        const bool isGap = next == count || i * count < next * over;
        const TriangleId leaf = isGap ? TriangleId() : leaves[next++];
        arena.used |= std::uint64_t{!isGap} << i;
        if (i >= over)
            _leaves[arena.first + i] = {}; // not drawn
        else if (isFresh || _leaves[arena.first + i] != leaf)
            replace(arena.first + i, leaf, changes);
    }
}

/// Releases the slots that an arena does not need.
void LeafArena::settle(std::uint32_t index, MeshChanges& changes)
{
    const Arena arena = _arenas[index];
    const std::uint32_t count = arena.count();
    if (8 * count > kFew * arena.slots()) return;
    if (arena.next != kNone && join(index, arena.next, changes)) return;
    if (arena.previous != kNone && join(arena.previous, index, changes)) return;
    std::uint32_t sizeClass = arena.sizeClass;
    while (sizeClass > SlotBlocks::kSmallestClass && 8 * count <= kFew << sizeClass)
        --sizeClass;
    if (sizeClass == arena.sizeClass) return;
    _taken.clear();
    takeUp(arena);
    giveSlots(index);
    takeSlots(index, sizeClass);
    lay(index, _taken, true, changes);
}

/// Moves all leaves of two neighbours into the larger one, if that leaves enough gaps.
bool LeafArena::join(std::uint32_t earlier, std::uint32_t later, MeshChanges& changes)
{
    const bool isLaterLarger = _arenas[later].sizeClass > _arenas[earlier].sizeClass;
    const std::uint32_t kept = isLaterLarger ? later : earlier, gone = isLaterLarger ? earlier : later;
    if (8 * (_arenas[earlier].count() + _arenas[later].count()) > kMany * _arenas[kept].slots()) return false;
    _taken.clear();
    takeUp(_arenas[earlier]);
    takeUp(_arenas[later]);
    removeArena(gone);
    lay(kept, _taken, false, changes);
    return true;
}

std::uint32_t LeafArena::addArena(std::uint32_t region, std::uint32_t previous, std::uint32_t sizeClass)
{
    if (_freeArenas.empty())
    {
        _freeArenas.push_back(static_cast<std::uint32_t>(_arenas.size()));
        appendTightly(_arenas);
    }
    const std::uint32_t index = _freeArenas.back();
    _freeArenas.pop_back();
    Arena& arena = _arenas[index];
    std::uint32_t& link = previous == kNone ? _firstArena[region] : _arenas[previous].next;
    arena = {};
    arena.region = region;
    arena.previous = previous;
    arena.next = std::exchange(link, index);
    if (arena.next != kNone) _arenas[arena.next].previous = index;
    takeSlots(index, sizeClass);
    return index;
}

void LeafArena::removeArena(std::uint32_t index)
{
    giveSlots(index);
    Arena& arena = _arenas[index];
    (arena.previous == kNone ? _firstArena[arena.region] : _arenas[arena.previous].next) = arena.next;
    if (arena.next != kNone) _arenas[arena.next].previous = arena.previous;
    arena.region = kNone;
    _freeArenas.push_back(index);
}

void LeafArena::takeSlots(std::uint32_t index, std::uint32_t sizeClass)
{
    const std::uint32_t first = _blocks.take(sizeClass);
    while (_leaves.size() < _blocks.slotCount())
        appendTightly(_leaves);
    _arenaOfGroup.resize(_leaves.size() / SlotBlocks::kSmallest, kNone);
    Arena& arena = _arenas[index];
    arena.first = first;
    arena.sizeClass = sizeClass;
    std::fill_n(_arenaOfGroup.begin() + first / SlotBlocks::kSmallest, arena.slots() / SlotBlocks::kSmallest,
                index);
}

void LeafArena::giveSlots(std::uint32_t index)
{
    const Arena& arena = _arenas[index];
    std::fill_n(_leaves.begin() + arena.first, arena.slots(), TriangleId());
    std::fill_n(_arenaOfGroup.begin() + arena.first / SlotBlocks::kSmallest,
                arena.slots() / SlotBlocks::kSmallest, kNone);
    _blocks.give(arena.first, arena.sizeClass);
}

} // namespace osgTerrainROAM::core
