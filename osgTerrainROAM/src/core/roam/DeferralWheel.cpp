// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <osgTerrainROAM/core/roam/DeferralWheel.h>
#include <osgTerrainROAM/core/roam/MeshData.h>

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

DeferralWheel::Mark DeferralWheel::markOf(int octave, int level, int slot)
{
    return static_cast<Mark>(1 + ((octave * 97 + level * 31 + slot) & 127));
}

void DeferralWheel::push(std::uint32_t& first, std::uint32_t watch)
{
    if (first == kNone || _blocks[first].count == kPerBlock)
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
        _blocks[block].next = first;
        _blocks[block].count = 0;
        first = block;
    }
    Block& block = _blocks[first];
    block.watches[block.count++] = watch;
}

DeferralWheel::Mark DeferralWheel::add(std::uint32_t watch, double errorM, double marginM)
{
    // The exponent of a float, without a call: |f| and e are finite and not negative.
    const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(errorM) >> 52) - 1023;
    const int which = std::clamp(exponent - kLowestExponent, 0, kOctaves - 1);
    Octave& octave = _octaves[static_cast<std::size_t>(which)];
    const auto now = static_cast<std::int64_t>(octave.clockTicks);
    const auto due = static_cast<std::int64_t>(octave.clockTicks + marginM * _ticksPerM);
    if (due == now)
    {
        push(octave.soon, watch);
        return markOf(which, kLevels, 0);
    }
    // The finest level whose slots reach so far; from bit to bit that is half a level.
    const int bits = static_cast<int>(std::bit_width(static_cast<std::uint64_t>(due - now)));
    int level = std::clamp((bits - kSlotBits + 1) / kLevelShift, 0, kLevels - 1);
    if ((due >> (kLevelShift * level)) - (now >> (kLevelShift * level)) >= kSlots)
        level = std::min(level + 1, kLevels - 1);
    const int shift = kLevelShift * level;
    const std::int64_t bucket =
        std::min(due >> shift, (now >> shift) + kSlots - 1); // the last level holds the rest
    const auto slot = static_cast<std::size_t>(bucket & (kSlots - 1));
    octave.occupied[static_cast<std::size_t>(level)] |= 1u << slot;
    push(octave.slots[static_cast<std::size_t>(level)][slot], watch);
    return markOf(which, level, static_cast<int>(slot));
}

void DeferralWheel::advance(double travelM, double scaleChange)
{
    for (int octave = kOctaves - 1; octave >= 0; --octave)
        collect(octave, travelM, scaleChange);
}

void DeferralWheel::makeDue(std::uint32_t& first, Mark mark)
{
    if (first != kNone) _due.push_back({std::exchange(first, kNone), mark});
}

DeferralWheel::Batch DeferralWheel::nextDue()
{
    Batch batch;
    if (!hasDue()) return batch;
    Chain& chain = _due[_nextDue];
    const std::uint32_t block = chain.block;
    batch.count = _blocks[block].count;
    batch.mark = chain.mark;
    batch.watches = _blocks[block].watches;
    chain.block = _blocks[block].next;
    _blocks[block].next = _freeBlock;
    _freeBlock = block;
    if (chain.block == kNone) ++_nextDue;
    if (_nextDue == _due.size())
    {
        _due.clear();
        _nextDue = 0;
    }
    return batch;
}

void DeferralWheel::collect(int which, double travelM, double scaleChange)
{
    const double steppedM = travelM + std::ldexp(scaleChange, which + kLowestExponent + 1);
    if (steppedM <= 0.0) return;
    Octave& octave = _octaves[static_cast<std::size_t>(which)];
    const auto before = static_cast<std::int64_t>(octave.clockTicks);
    octave.clockTicks += steppedM * _ticksPerM;
    const auto now = static_cast<std::int64_t>(octave.clockTicks);
    makeDue(octave.soon, markOf(which, kLevels, 0));
    for (int level = 0; level < kLevels; ++level)
    {
        const std::int64_t from = before >> (kLevelShift * level), to = now >> (kLevelShift * level);
        if (from == to) break; // coarser levels have not moved either
        std::uint32_t& occupied = octave.occupied[static_cast<std::size_t>(level)];
        if (occupied == 0) continue;
        for (std::int64_t bucket = from + 1; bucket <= std::min(to, from + kSlots); ++bucket)
        {
            const auto slot = static_cast<std::size_t>(bucket & (kSlots - 1));
            if (!(occupied >> slot & 1u)) continue;
            occupied &= ~(1u << slot);
            makeDue(octave.slots[static_cast<std::size_t>(level)][slot],
                    markOf(which, level, static_cast<int>(slot)));
        }
    }
}

std::size_t DeferralWheel::memoryBytes() const
{
    return _octaves.capacity() * sizeof(Octave) + _blocks.capacity() * sizeof(Block) +
           _due.capacity() * sizeof(Chain);
}

} // namespace osgTerrainROAM::core
