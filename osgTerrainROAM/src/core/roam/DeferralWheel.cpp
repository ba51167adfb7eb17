// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/roam/DeferralWheel.h>

namespace osgTerrainROAM::core
{

DeferralWheel::DeferralWheel(double tickM) : _ticksPerM(1.0 / tickM)
{
    clear();
}

void DeferralWheel::clear()
{
    Octave empty;
    empty.soon = kNone;
    for (auto& level : empty.slots)
        level.fill(kNone);
    _octaves.assign(kOctaves, empty);
    _blocks.clear();
    _freeBlock = kNone;
    _due.clear();
    _nextDue = 0;
}

/// Starts a block in front of the chain `next`.
std::uint32_t DeferralWheel::startBlock(std::uint32_t next)
{
    std::uint32_t block = _freeBlock;
    if (block == kNone)
    {
        block = static_cast<std::uint32_t>(_blocks.size());
        appendTightly(_blocks);
    }
    else
    {
        _freeBlock = _blocks[block].next;
    }
    _blocks[block].next = next;
    _blocks[block].count = 0;
    return block;
}

void DeferralWheel::advance(double travelM, double scaleChange)
{
    double largestChangeM = std::ldexp(scaleChange, kOctaves + kLowestExponent); // of the octave's upper end
    for (int octave = kOctaves - 1; octave >= 0; --octave, largestChangeM *= 0.5)
        collect(octave, travelM + largestChangeM);
}

void DeferralWheel::makeDue(std::uint32_t& first, Mark mark)
{
    if (first != kNone) _due.push_back({std::exchange(first, kNone), mark});
}

void DeferralWheel::nextDue(Batch& batch)
{
    batch.count = 0;
    while (hasDue())
    {
        Chain& chain = _due[_nextDue];
        Block& block = _blocks[chain.block];
        if (batch.count + block.count > Batch::kMost) return;
        for (std::uint32_t i = 0; i < block.count; ++i, ++batch.count)
        {
            batch.watches[batch.count] = block.watches[i];
            batch.marks[batch.count] = chain.mark;
        }
        const std::uint32_t next = block.next;
        block.next = _freeBlock;
        _freeBlock = std::exchange(chain.block, next);
        if (next == kNone) ++_nextDue;
    }
    _due.clear();
    _nextDue = 0;
}

void DeferralWheel::collect(int which, double steppedM)
{
    if (steppedM <= 0.0) return;
    Octave& octave = _octaves[static_cast<std::size_t>(which)];
    const std::int64_t before = octave.nowTicks;
    octave.clockTicks += steppedM * _ticksPerM;
    const std::int64_t now = octave.nowTicks = static_cast<std::int64_t>(octave.clockTicks);
    makeDue(octave.soon, markOf(which, kLevels, 0));
    for (int level = 0; level < kLevels; ++level)
    {
        const std::int64_t from = before >> (kLevelShift * level), to = now >> (kLevelShift * level);
        if (from == to) break; // coarser levels have not moved either
        std::uint32_t& occupied = octave.occupied[static_cast<std::size_t>(level)];
        // The slots that were passed, the one after `from` first.
        const auto first = static_cast<int>((from + 1) & (kSlots - 1));
        std::uint32_t passed = std::rotr(occupied, first);
        if (to - from < kSlots) passed &= (1u << (to - from)) - 1u;
        for (occupied &= ~std::rotl(passed, first); passed != 0; passed &= passed - 1u)
        {
            const int slot = (std::countr_zero(passed) + first) & (kSlots - 1);
            makeDue(octave.slots[static_cast<std::size_t>(level)][static_cast<std::size_t>(slot)],
                    markOf(which, level, slot));
        }
    }
}

std::size_t DeferralWheel::memoryBytes() const
{
    return _octaves.capacity() * sizeof(Octave) + _blocks.capacity() * sizeof(Block) +
           _due.capacity() * sizeof(Chain);
}

} // namespace osgTerrainROAM::core
