// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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
    static constexpr std::size_t kPerBlock = 14;
    using Mark = std::uint8_t; ///< of a bucket, 1 to 128; different buckets seldom share one

    /// `tickM`: margins below it are due at the next step.
    explicit DeferralWheel(double tickM);

    /// Asks for `watch` (any number) once its margin is used up. Returns the mark it will be handed out with.
    Mark add(std::uint32_t watch, double errorM, double marginM);

    /// Some watches that are due, and the mark that they were asked for with.
    struct Batch
    {
        std::array<std::uint32_t, kPerBlock> watches;
        std::uint32_t count = 0;
        Mark mark = 0;
    };

    /// The eye has travelled, the scale K/τ has changed: whatever may have used up its margin is due, larger errors first,
    /// after what was due before. Cost: that of the buckets, not of what is in them.
    void advance(double travelM, double scaleChange);

    /// The next of what is due; an empty batch when there is no more.
    Batch nextDue();
    bool hasDue() const { return _nextDue < _due.size(); }

    void clear();
    std::size_t memoryBytes() const;

private:
    static constexpr int kOctaves = 32, kLowestExponent = -16; ///< 2^-16 m … 2^16 m
    static constexpr int kLevels = 13, kSlotBits = 5, kSlots = 1 << kSlotBits, kLevelShift = 2;

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
        std::uint32_t soon;                            ///< blocks of what is due at the next step
        std::array<std::uint32_t, kLevels> occupied{}; ///< slots that have blocks
        std::array<std::array<std::uint32_t, kSlots>, kLevels> slots; ///< first blocks
    };

    struct Chain
    {
        std::uint32_t block;
        Mark mark;
    };

    static Mark markOf(int octave, int level, int slot);
    void push(std::uint32_t& first, std::uint32_t watch);
    void collect(int octave, double travelM, double scaleChange);
    void makeDue(std::uint32_t& first, Mark mark);

    double _ticksPerM;
    std::vector<Octave> _octaves;
    std::vector<Block> _blocks;
    std::uint32_t _freeBlock;
    std::vector<Chain> _due; ///< from _nextDue on
    std::size_t _nextDue = 0;
};

} // namespace osgTerrainROAM::core
