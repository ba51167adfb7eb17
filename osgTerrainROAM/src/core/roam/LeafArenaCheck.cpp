// SPDX-License-Identifier: Apache-2.0
// The exhaustive check of LeafArena::isConsistent.
#include <algorithm>

#include <osgTerrainROAM/core/roam/LeafArena.h>

namespace osgTerrainROAM::core
{

namespace
{

/// The slots that were found in a block.
class Claims
{
public:
    explicit Claims(std::uint32_t slots) : _claimed(slots, false) {}

    bool claim(std::uint32_t first, std::uint32_t count)
    {
        for (std::uint32_t slot = first; slot < first + count; ++slot)
        {
            if (slot >= _claimed.size() || _claimed[slot]) return false; // blocks overlap
            _claimed[slot] = true;
        }
        return true;
    }

    bool areAll() const
    {
        return std::all_of(_claimed.begin(), _claimed.end(), [](bool isClaimed) { return isClaimed; });
    }

private:
    std::vector<bool> _claimed;
};

} // namespace

/// Whether an arena's counts and links agree with its leaves and slots.
bool LeafArena::isSound(std::uint32_t index) const
{
    const Arena& arena = _arenas[index];
    if (arena.sizeClass < SlotBlocks::kSmallestClass || arena.sizeClass > SlotBlocks::kLargestClass)
        return false;
    if (arena.used == 0 || arena.cut != 0 || arena.first + arena.slots() > slotCount()) return false;
    for (std::uint32_t i = 0; i < 64; ++i)
    {
        const bool isUsed = (arena.used >> i & 1u) != 0;
        if (i >= arena.slots() ? isUsed : isUsed != _leaves[arena.first + i].exists()) return false;
        if (i < arena.slots() && arenaAt(arena.first + i) != index) return false;
    }
    return true;
}

bool LeafArena::isConsistent() const
{
    std::size_t leaves = 0, arenas = _freeArenas.size();
    Claims claims(slotCount());
    for (std::uint32_t region = 0; region < regionCount(); ++region)
        for (std::uint32_t index = _firstArena[region], before = kNone; index != kNone;
             before = index, index = _arenas[index].next, ++arenas)
        {
            const Arena& arena = _arenas[index];
            if (arena.region != region || arena.previous != before || !isSound(index)) return false;
            if (!claims.claim(arena.first, arena.slots())) return false;
            leaves += arena.count();
        }
    bool isFreeSound = true;
    _blocks.forEachFree(
        [&](std::uint32_t first, std::uint32_t count)
        {
            isFreeSound = isFreeSound && claims.claim(first, count) &&
                          std::none_of(_leaves.begin() + first, _leaves.begin() + first + count,
                                       [](TriangleId leaf) { return leaf.exists(); });
        });
    return isFreeSound && claims.areAll() && leaves == _leafCount && arenas == _arenas.size() &&
           _touched.empty();
}

} // namespace osgTerrainROAM::core
