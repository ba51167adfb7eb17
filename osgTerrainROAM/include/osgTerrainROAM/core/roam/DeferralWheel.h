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

/// Hands out what has to be looked at again, and no sooner than its margin is used up.
/// Whoever watches a split vertex v asks for it at margin |f_v|: f_v changes by no more than the eye travels plus e_v
/// times the change of the scale K/τ. So there is one clock per octave of e, which advances by the travel and by the
/// octave's upper end times the change of scale; a watch is due when its octave's clock has advanced by its margin,
/// rounded down: to a tick, and where the margin is long by up to an eighth.
/// Each octave has a timing wheel of levels, each four times as coarse as the one before, whose entries never move between
/// levels. Numbers are all that is kept: a watch that is no longer wanted is still handed out, and who asked for it
/// recognises it by its mark.
/// Memory: 4 B per watch, in blocks of 64 B. Cost: O(1) for a watch, a few words per octave for a step.
/// Source: spec 1 D, "Deferral"; terrain anchors, point 2. The wheel without cascades is that of Linux timers.
class DeferralWheel
{
public:
    using Mark = std::uint8_t; ///< of a bucket, 1 to 128; different buckets seldom share one

    /// `tickM`: margins below it are due at the next step.
    explicit DeferralWheel(double tickM);

    /// Asks for `watch` (any number) once its margin is used up; a negative one already is. Returns the mark it will be
    /// handed out with.
    Mark add(std::uint32_t watch, float errorM, double marginM);

    /// Some watches that are due, and the marks that they were asked for with.
    struct Batch
    {
        static constexpr std::size_t kMost = 32;
        std::array<std::uint32_t, kMost> watches;
        std::array<Mark, kMost> marks;
        std::uint32_t count = 0;
    };

    /// The eye has travelled, the scale K/τ has changed: whatever may have used up its margin is due, larger errors first,
    /// after what was due before. Cost: that of the buckets, not of what is in them.
    void advance(double travelM, double scaleChange);

    /// Puts the next of what is due into a batch; none when there is no more.
    void nextDue(Batch& batch);
    bool hasDue() const { return _nextDue < _due.size(); }

    void clear();
    std::size_t memoryBytes() const;

private:
    static constexpr int kOctaves = 32, kLowestExponent = -16; ///< 2^-16 m … 2^16 m
    static constexpr int kLevels = 13, kSlotBits = 5, kSlots = 1 << kSlotBits, kLevelShift = 2;

    static constexpr std::size_t kPerBlock = 14;

    /// By the highest bit of the ticks to come.
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

// Compiled into who looks at watches: this is done for every one of them.
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
