// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

#include <osgPMObjects/core/progressive/Bytes.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "SlotWriter.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

/// Plays the rearrangements that appendRecord() wrote, forth and back; returns how many faces changed their
/// slots.
template<class Index>
class RearrangementReader
{
public:
    using Slots = SlotWriter<Index>;
    using Slot = typename Slots::Slot;

    /// `extents`: by block; rearrangements change them.
    RearrangementReader(const ProgressiveMesh& progressive, std::vector<std::uint32_t>& extents)
        : _progressive(progressive),
          _widths(progressive),
          _extents(extents),
          _faces(progressive.mostSlotsMoved),
          _window(progressive.mostSlotsMoved),
          _chain(progressive.mostSlotsMoved)
    {
        _blocks.reserve(progressive.blocks.size());
        _extentsBefore.reserve(progressive.blocks.size());
    }

    /// The most that one rearrangement notes (SlotWriter).
    static std::size_t mostNotes(const ProgressiveMesh& progressive)
    {
        return std::size_t{progressive.mostSlotsMoved} + 2 * progressive.blocks.size() + 2;
    }

    std::uint32_t forth(ByteReader& in, Slots& slots)
    {
        const std::uint32_t head = in.number();
        if (head == 0) return cyclesForth(in, slots);
        return head & 1 ? chainForth(in, head >> 1, slots) : rewriteForth(in, head >> 1, slots);
    }

    std::uint32_t back(ByteReader& in, Slots& slots)
    {
        const std::uint32_t head = in.number();
        if (head == 0) return cyclesBack(in, slots);
        return head & 1 ? chainBack(in, head >> 1, slots) : rewriteBack(in, head >> 1, slots);
    }

    void skip(ByteReader& in)
    {
        const std::uint32_t head = in.number();
        if (head == 0) return skipCycles(in);
        if (head & 1)
        {
            in.number();
            readChain(in, head >> 1);
            return;
        }
        readWindow(in, head >> 1);
        for (std::uint32_t live = in.number(); live > 0; --live)
            in.number();
    }

private:
    void readChain(ByteReader& in, std::uint32_t moves)
    {
        _chain[0] = in.fixed(_widths.slot);
        for (std::uint32_t i = 1; i <= moves; ++i)
            _chain[i] = _chain[i - 1] + in.difference();
    }

    std::uint32_t chainForth(ByteReader& in, std::uint32_t moves, Slots& slots)
    {
        --_extents[in.number()];
        readChain(in, moves);
        for (std::uint32_t i = 0; i < moves; ++i)
            slots.put(_chain[i], slots[_chain[i + 1]]);
        slots.makeUnused(_chain[moves], 1);
        slots.note(_chain[moves] + 1);
        return moves;
    }

    std::uint32_t chainBack(ByteReader& in, std::uint32_t moves, Slots& slots)
    {
        ++_extents[in.number()];
        readChain(in, moves);
        for (std::uint32_t i = moves; i > 0; --i)
            slots.put(_chain[i], slots[_chain[i - 1]]);
        slots.makeHole(_chain[0]);
        return moves;
    }

    /// What stands before the slots of cycles (SlotCycles).
    struct CyclesHead
    {
        std::uint32_t block, extent, shrinks;
        FixedWidth width;

        explicit CyclesHead(ByteReader& in)
            : block(in.number()), extent(in.number()), shrinks(in.number()), width(widthFor(extent))
        {
        }
    };

    /// Reads a slot of a cycle; `first`: the first of its block.
    static std::uint32_t slotOfCycle(ByteReader& in, const FixedWidth& width, std::uint32_t first)
    {
        return first + in.fixed(width);
    }

    /// The cycle through the holes ends with a slot that is unused afterwards, so nothing goes there.
    std::uint32_t cyclesForth(ByteReader& in, Slots& slots)
    {
        const CyclesHead head(in);
        const std::uint32_t first = firstSlot(head.block), holes = in.number();
        std::uint32_t slot = first, moves = holes - head.shrinks;
        if (holes > 0) slot = slotOfCycle(in, head.width, first);
        for (std::uint32_t i = 1; i < holes; ++i)
        {
            const std::uint32_t next = slotOfCycle(in, head.width, first);
            slots.move(slot, next);
            slot = next;
        }
        for (std::uint32_t others = in.number(); others > 0; --others)
        {
            const std::uint32_t length = in.number();
            slot = slotOfCycle(in, head.width, first);
            const Slot face = slots[slot];
            for (std::uint32_t i = 1; i < length; ++i)
            {
                const std::uint32_t next = slotOfCycle(in, head.width, first);
                slots.move(slot, next);
                slot = next;
            }
            slots.set(slot, face);
            moves += length;
        }
        _extents[head.block] = head.extent - head.shrinks;
        trim(head.block, head.extent, slots);
        return moves;
    }

    /// The slots that were unused are the holes that the cycle takes back. A carried face changes places with
    /// the one in each slot, in the order of the bytes: so the way back needs neither memory nor a second
    /// list.
    std::uint32_t cyclesBack(ByteReader& in, Slots& slots)
    {
        const CyclesHead head(in);
        const std::uint32_t first = firstSlot(head.block), holes = in.number();
        std::uint32_t moves = holes - head.shrinks;
        _extents[head.block] = head.extent;
        slots.fill(first + head.extent - head.shrinks, head.shrinks, [](std::uint32_t) { return Slot{}; });
        Slot carried{};
        for (std::uint32_t i = 0; i < holes; ++i)
            carried = slots.exchange(slotOfCycle(in, head.width, first), carried);
        for (std::uint32_t others = in.number(); others > 0; --others)
        {
            const std::uint32_t length = in.number(), begin = slotOfCycle(in, head.width, first);
            carried = slots[begin];
            for (std::uint32_t i = 1; i < length; ++i)
                carried = slots.exchange(slotOfCycle(in, head.width, first), carried);
            slots.set(begin, carried);
            moves += length;
        }
        slots.note(endSlot(head.block));
        return moves;
    }

    void skipCycles(ByteReader& in)
    {
        const CyclesHead head(in);
        const auto skipSlots = [&] { in.skip(static_cast<int>(in.number()) * head.width.bytes); };
        skipSlots();
        for (std::uint32_t others = in.number(); others > 0; --others)
            skipSlots();
    }

    void readWindow(ByteReader& in, std::uint32_t count)
    {
        _blocks.clear();
        _extentsBefore.clear();
        for (std::uint32_t b = 0; b < count; ++b)
            _blocks.push_back(in.number() + (b == 0 ? 0 : _blocks.back()));
        for (std::uint32_t b = 0; b < count; ++b)
            _extentsBefore.push_back(in.number());
    }

    std::uint32_t firstSlot(std::uint32_t block) const { return _progressive.blocks[block].firstSlot; }
    std::uint32_t endSlot(std::uint32_t block) const { return _progressive.endSlot(block); }

    /// Copies the drawn slots of the window's blocks into one list.
    void gather(const Slots& slots, std::vector<Slot>& faces) const
    {
        std::size_t next = 0;
        for (const std::uint32_t block : _blocks)
        {
            const Slot* const first = &slots[firstSlot(block)];
            std::copy(first, first + _extents[block], faces.begin() + next);
            next += _extents[block];
        }
    }

    /// Marks the slots behind a block's extent as unused, up to its extent before.
    void trim(std::uint32_t block, std::uint32_t extentBefore, Slots& slots)
    {
        if (_extents[block] < extentBefore)
            slots.makeUnused(firstSlot(block) + _extents[block], extentBefore - _extents[block]);
        slots.note(endSlot(block));
    }

    std::uint32_t rewriteForth(ByteReader& in, std::uint32_t count, Slots& slots)
    {
        readWindow(in, count);
        gather(slots, _window);
        std::uint32_t live = in.number(), expected = 0, here = 0, moves = 0;
        for (std::uint32_t b = 0; b < count; ++b)
        {
            const std::uint32_t block = _blocks[b];
            _extents[block] = std::min(live, endSlot(block) - firstSlot(block));
            live -= _extents[block];
            slots.fill(firstSlot(block), _extents[block],
                       [&](std::uint32_t i)
                       {
                           const std::uint32_t source = expected + in.difference();
                           expected = source + 1;
                           moves += source != here + i || i >= _extentsBefore[b];
                           return _window[source];
                       });
            trim(block, _extentsBefore[b], slots);
            here += _extentsBefore[b];
        }
        return moves;
    }

    std::uint32_t rewriteBack(ByteReader& in, std::uint32_t count, Slots& slots)
    {
        readWindow(in, count);
        gather(slots, _faces);
        constexpr Slot kHole{};
        std::fill_n(_window.begin(), std::accumulate(_extentsBefore.begin(), _extentsBefore.end(), 0u),
                    kHole);
        in.number();
        std::uint32_t expected = 0, here = 0, face = 0, moves = 0;
        for (std::uint32_t b = 0; b < count; ++b)
        {
            for (std::uint32_t i = 0; i < _extents[_blocks[b]]; ++i)
            {
                const std::uint32_t source = expected + in.difference();
                expected = source + 1;
                moves += source != here + i || i >= _extentsBefore[b];
                _window[source] = _faces[face++];
            }
            here += _extentsBefore[b];
        }
        std::uint32_t next = 0;
        for (std::uint32_t b = 0; b < count; ++b)
        {
            const std::uint32_t block = _blocks[b], extentNow = _extents[block];
            _extents[block] = _extentsBefore[b];
            slots.fill(
                firstSlot(block), _extents[block],
                [&](std::uint32_t i) { return !Slots::isHole(_window[next + i]); },
                [&](std::uint32_t i) { return _window[next + i]; });
            next += _extents[block];
            trim(block, extentNow, slots);
        }
        return moves;
    }

    const ProgressiveMesh& _progressive;
    RecordWidths _widths;
    std::vector<std::uint32_t>& _extents;
    std::vector<Slot> _faces, _window;
    std::vector<std::uint32_t> _chain, _blocks, _extentsBefore;
};

} // namespace osgPMObjects::core
