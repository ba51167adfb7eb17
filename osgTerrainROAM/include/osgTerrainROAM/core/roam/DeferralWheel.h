// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgTerrainROAM/core/roam/MeshData.h>

namespace osgTerrainROAM::core
{

/// The queue of split vertices whose decision has to be checked again: it hands each out when its margin may
/// be used up. The decision f_v of a vertex changes by no more than the eye travels plus e_v times the change
/// of the scale K/τ, so it holds while that sum is below the margin |f_v|. There is one clock per octave of
/// e: it advances by the travel and by the octave's upper end times the change of scale. A watch is due when
/// its octave's clock has advanced by its margin, rounded down: to a tick, and for a long margin by up to an
/// eighth. Each octave has a timing wheel of levels, each four times as coarse as the one before; entries
/// never move between levels.
/// The wheel stores numbers only: a cancelled watch is still handed out, and its owner recognises it by its
/// mark.
/// Memory: 4 B per watch, in blocks of 64 B. Cost: O(1) for a watch, a few words per octave for a step.
/// Source: Varghese & Lauck, *Hashed and hierarchical timing wheels*, 1987; without cascades, as the timers
/// of Linux since 4.8.
class DeferralWheel
{
public:
    using Mark = std::uint8_t; ///< of a bucket, 1 to 128; different buckets seldom share one

    /// `tickM`: watches with a smaller margin are due at the next step.
    explicit DeferralWheel(double tickM);

    /// Adds `watch` (any number), due when its margin is used up; with a negative margin, at the next step.
    /// Returns the mark that it will be handed out with.
    Mark add(std::uint32_t watch, float errorM, double marginM);

    /// A batch of due watches, and the marks that add() returned for them.
    struct Batch
    {
        static constexpr std::size_t kMost = 32;
        std::array<std::uint32_t, kMost> watches;
        std::array<Mark, kMost> marks;
        std::uint32_t count = 0;
    };

    /// Advances the clocks after the eye has travelled and the scale K/τ has changed: watches whose margin
    /// may be used up become due, those with larger errors first, after those that are due already. Cost:
    /// that of the buckets, not of their entries.
    void advance(double travelM, double scaleChange);

    /// Fills a batch with the next due watches; it is empty when there are no more.
    void nextDue(Batch& batch);
    bool hasDue() const { return _nextDue < _due.size(); }

    void clear();
    std::size_t memoryBytes() const;

private:
    static constexpr int kOctaves = 32, kLowestExponent = -16; ///< 2^-16 m … 2^16 m
    static constexpr int kLevels = 13, kSlotBits = 5, kSlots = 1 << kSlotBits, kLevelShift = 2;

    static constexpr std::size_t kPerBlock = 14;

    /// The level of a watch by the highest bit of the ticks until it is due.
    static constexpr std::array<std::uint8_t, 64> kLevelOfBit = []
    {
        std::array<std::uint8_t, 64> levels{};
        for (int bit = 0; bit < 64; ++bit)
            levels[static_cast<std::size_t>(bit)] =
                static_cast<std::uint8_t>(std::clamp((bit + 2 - kSlotBits) / kLevelShift, 0, kLevels - 1));
        return levels;
    }();

    struct Block
    {
        std::uint32_t next;
        std::uint32_t count;
        std::array<std::uint32_t, kPerBlock> watches;
    };
    static_assert(sizeof(Block) == 64);

    struct Octave
    {
        double clockTicks = 0.0;
        std::int64_t nowTicks = 0;                     ///< the same, rounded down
        std::uint32_t soon;                            ///< blocks of what is due at the next step
        std::array<std::uint32_t, kLevels> occupied{}; ///< slots that have blocks
        std::array<std::array<std::uint32_t, kSlots>, kLevels> slots; ///< first blocks
    };

    struct Chain
    {
        std::uint32_t block;
        Mark mark;
    };

    static Mark markOf(int octave, int level, int slot)
    {
        return static_cast<Mark>(1 + ((octave * 97 + level * 31 + slot) & 127));
    }
    static int octaveOf(float errorM)
    {
        // The exponent of a float, without a call: e is finite and not negative.
        const int exponent = static_cast<int>(std::bit_cast<std::uint32_t>(errorM) >> 23) - 127;
        return std::clamp(exponent - kLowestExponent, 0, kOctaves - 1);
    }
    std::uint32_t startBlock(std::uint32_t next);
    void push(std::uint32_t& first, std::uint32_t watch)
    {
        if (first == kNone || _blocks[first].count == kPerBlock) first = startBlock(first);
        Block& block = _blocks[first];
        block.watches[block.count++] = watch;
    }
    void collect(int octave, double steppedM);
    void makeDue(std::uint32_t& first, Mark mark);

    double _ticksPerM;
    std::vector<Octave> _octaves;
    std::vector<Block> _blocks;
    std::uint32_t _freeBlock;
    std::vector<Chain> _due; ///< from _nextDue on
    std::size_t _nextDue = 0;
};

// Inline: this runs once for every check of a vertex.
inline DeferralWheel::Mark DeferralWheel::add(std::uint32_t watch, float errorM, double marginM)
{
    const int which = octaveOf(errorM);
    Octave& octave = _octaves[static_cast<std::size_t>(which)];
    const std::int64_t now = octave.nowTicks;
    const auto due = static_cast<std::int64_t>(octave.clockTicks + marginM * _ticksPerM);
    if (due <= now)
    {
        push(octave.soon, watch);
        return markOf(which, kLevels, 0);
    }
    // The finest level whose slots reach so far; from bit to bit that is half a level.
    const int highest = 63 - std::countl_zero(static_cast<std::uint64_t>(due - now));
    int level = kLevelOfBit[static_cast<std::size_t>(highest)];
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

} // namespace osgTerrainROAM::core
