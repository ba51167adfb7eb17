// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <osgPMObjects/core/progressive/CheckedReader.h>

#include "ProgressiveMeshCheck.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

/// Checks all records in the order of vertex splits, from the coarsest level to the finest.
class RecordCheck
{
public:
    explicit RecordCheck(const ProgressiveMesh& progressive)
        : _progressive(progressive),
          _widths(progressive),
          _wedges(progressive.wedgesAfter(progressive.stepCount))
    {
        for (const FaceBlock& block : progressive.blocks)
            _extents.push_back(block.extent);
    }

    /// Returns the sizes of the buffers that players need; nothing if a record is not valid.
    std::optional<PlayerNeeds> needs()
    {
        const std::byte* const begin = _progressive.records.data();
        const std::byte* end = begin + _progressive.records.size() - kRecordPadding;
        for (std::uint32_t step = _progressive.stepCount; step-- > 0;)
        {
            const std::byte* const from = beginBefore(begin, end);
            if (from == nullptr || !isRecord(from, end, step)) return {};
            end = from;
        }
        if (end != begin) return {};
        return _needs;
    }

private:
    static const std::byte* beginBefore(const std::byte* begin, const std::byte* end)
    {
        if (end == begin) return nullptr;
        std::size_t length = static_cast<std::size_t>(end[-1]) + 1;
        if (length == 1)
        {
            if (end - begin < 5) return nullptr;
            length = std::size_t{CheckedReader(end - 5, end).fixed(FixedWidth(4))} + 5;
        }
        return length > static_cast<std::size_t>(end - begin) ? nullptr : end - length;
    }

    bool isRecord(const std::byte* begin, const std::byte* end, std::uint32_t step)
    {
        CheckedReader in(begin, end);
        const std::uint32_t head = in.byte();
        std::uint32_t vanished = head & 3, patched = head >> 2 & 15, wedges = 1;
        if (vanished == 3) vanished = in.number();
        if (patched == 15) patched = in.number();
        std::vector<std::uint32_t> patchedOfWedge{patched};
        if (head & 0x40)
        {
            wedges = in.number();
            if (wedges > _progressive.mesh.wedgeCount() - _wedges) return false;
            patchedOfWedge.clear();
            std::uint64_t sum = 0;
            for (std::uint32_t i = 0; i < wedges; ++i)
                sum += patchedOfWedge.emplace_back(in.number());
            if (sum != patched) return false;
        }
        if (wedges != wedgesOf(step) || !in.isGood()) return false;
        if (std::uint64_t{patched} + vanished > _progressive.slotCount) return false;
        _wedges += wedges;
        std::vector<std::uint32_t> slots;
        SlotLists lists(in, _widths.slot);
        const auto keep = [&](std::uint32_t slot) { slots.push_back(slot); };
        for (const std::uint32_t count : patchedOfWedge)
            lists.visit(count, keep);
        lists.visit(vanished, keep);
        for (std::uint32_t i = 0; i < vanished; ++i)
            if (!isVanishedFace(in, patched)) return false;
        if ((head & 0x80) && !areRearrangements(in)) return false;
        const std::size_t length = static_cast<std::size_t>(in.at() - begin);
        _needs.slotsOfStep = std::max(_needs.slotsOfStep, patched + vanished);
        return in.isGood() && skipLength(in.at(), length) == end &&
               std::all_of(slots.begin(), slots.end(), [this](std::uint32_t s) { return isDrawn(s); });
    }

    std::uint32_t wedgesOf(std::uint32_t step) const
    {
        const auto& positions = _progressive.mesh.wedgePositions;
        const std::size_t position = _progressive.mesh.positions.size() - 1 - step;
        std::uint32_t count = 0;
        while (_wedges + count < positions.size() && positions[_wedges + count] == position)
            ++count;
        return count;
    }

    bool isVanishedFace(CheckedReader& in, std::uint32_t patched) const
    {
        const std::uint32_t code = in.byte();
        if (code != VanishedFace::kPlain) return VanishedFace::ofCode(code).patched < patched;
        for (int corner = 0; corner < 3; ++corner)
            if (in.fixed(_widths.wedge) >= _wedges) return false;
        return true;
    }

    bool isDrawn(std::uint32_t slot) const
    {
        const auto after =
            std::upper_bound(_progressive.blocks.begin(), _progressive.blocks.end(), slot,
                             [](std::uint32_t s, const FaceBlock& b) { return s < b.firstSlot; });
        if (after == _progressive.blocks.begin()) return false;
        return slot - (after - 1)->firstSlot < _extents[after - 1 - _progressive.blocks.begin()];
    }

    /// Checks the rearrangements of a record; they are undone from the last to the first.
    bool areRearrangements(CheckedReader& in)
    {
        const std::uint32_t count = in.number();
        if (count > _progressive.records.size()) return false;
        std::vector<Rearrangement> all;
        for (std::uint32_t i = 0; i < count && in.isGood(); ++i)
        {
            const std::uint32_t head = in.number();
            if (head >> 1 > _progressive.slotCount) return false;
            all.push_back(head == 0  ? readCycles(in)
                          : head & 1 ? readChain(in, head >> 1)
                                     : readRewrite(in, head >> 1));
        }
        if (!in.isGood()) return false;
        _needs.rearrangements = std::max(_needs.rearrangements, count);
        return std::all_of(all.rbegin(), all.rend(),
                           [this](const Rearrangement& r)
                           {
                               return r.kind == RearrangementKind::chain    ? undoChain(r)
                                      : r.kind == RearrangementKind::cycles ? undoCycles(r)
                                                                            : undoRewrite(r);
                           });
    }

    Rearrangement readChain(CheckedReader& in, std::uint32_t moves)
    {
        Rearrangement chain{RearrangementKind::chain, {in.number()}, {}, {}};
        chain.slots.push_back(in.fixed(_widths.slot));
        for (std::uint32_t i = 0; i < moves && in.isGood(); ++i)
            chain.slots.push_back(chain.slots.back() + static_cast<std::uint32_t>(in.difference()));
        return chain;
    }

    bool undoChain(const Rearrangement& chain)
    {
        const std::uint32_t block = chain.blocks.front();
        if (block >= _extents.size()) return false;
        const std::uint32_t first = _progressive.blocks[block].firstSlot;
        if (_extents[block] >= _progressive.endSlot(block) - first) return false;
        ++_extents[block];
        needSlots(chain.slots.size());
        return chain.slots.back() == first + _extents[block] - 1 &&
               std::all_of(chain.slots.begin(), chain.slots.end(),
                           [this](std::uint32_t slot) { return isDrawn(slot); });
    }

    /// Reads cycles: their block, its extents before and after, and all slots. Those that cannot be have no
    /// block.
    Rearrangement readCycles(CheckedReader& in)
    {
        const std::uint32_t block = in.number(), extent = in.number(), shrinks = in.number();
        Rearrangement cycles{RearrangementKind::cycles, {SlotTable::kNone}, {extent, extent - shrinks}, {}};
        if (extent > _progressive.slotCount || shrinks > extent) return cycles;
        readCycle(in, cycles);
        const std::size_t throughHoles = cycles.slots.size();
        bool areWhole = true;
        for (std::uint32_t others = in.number(); others > 0 && in.isGood(); --others)
            areWhole = readCycle(in, cycles) > 0 && areWhole;
        const auto goes = [&](std::uint32_t slot) { return slot >= extent - shrinks; };
        const auto other = cycles.slots.begin() + static_cast<std::ptrdiff_t>(throughHoles);
        // Each slot that goes ends the way to one hole; the last way ends the cycle.
        if (areWhole && std::count_if(cycles.slots.begin(), other, goes) == shrinks &&
            (throughHoles == 0 || goes(*(other - 1))) && std::none_of(other, cycles.slots.end(), goes))
            cycles.blocks.front() = block;
        return cycles;
    }

    /// Appends the slots of a cycle and returns their number.
    static std::uint32_t readCycle(CheckedReader& in, Rearrangement& cycles)
    {
        const FixedWidth width(widthFor(cycles.extents.front()));
        const std::uint32_t count = in.number();
        for (std::uint32_t i = 0; i < count && in.isGood(); ++i)
            cycles.slots.push_back(in.fixed(width));
        return count;
    }

    bool undoCycles(const Rearrangement& cycles)
    {
        const std::uint32_t block = cycles.blocks.front(), extent = cycles.extents.front();
        if (block >= _extents.size() || _extents[block] != cycles.extents.back()) return false;
        if (extent > _progressive.endSlot(block) - _progressive.blocks[block].firstSlot) return false;
        needSlots(extent - _extents[block]);
        _extents[block] = extent;
        std::vector<bool> isTaken(extent, false);
        for (const std::uint32_t slot : cycles.slots)
        {
            if (slot >= extent || isTaken[slot]) return false;
            isTaken[slot] = true;
        }
        return true;
    }

    Rearrangement readRewrite(CheckedReader& in, std::uint32_t count)
    {
        Rearrangement rewrite;
        for (std::uint32_t b = 0; b < count && in.isGood(); ++b)
            rewrite.blocks.push_back(in.number() + (b == 0 ? 0 : rewrite.blocks.back()));
        for (std::uint32_t b = 0; b < count && in.isGood(); ++b)
            rewrite.extents.push_back(in.number());
        const std::uint32_t live = in.number();
        std::uint32_t expected = 0;
        for (std::uint32_t i = 0; i < live && in.isGood(); ++i)
        {
            const std::uint32_t source = expected + static_cast<std::uint32_t>(in.difference());
            rewrite.slots.push_back(source);
            expected = source + 1;
        }
        return rewrite;
    }

    bool undoRewrite(const Rearrangement& rewrite)
    {
        std::size_t live = 0, slots = 0;
        for (std::size_t b = 0; b < rewrite.blocks.size(); ++b)
        {
            const std::uint32_t block = rewrite.blocks[b];
            if (block >= _extents.size() || (b > 0 && block <= rewrite.blocks[b - 1])) return false;
            const std::uint32_t capacity = _progressive.endSlot(block) - _progressive.blocks[block].firstSlot;
            // Blocks were filled one after the other.
            if (_extents[block] != std::min<std::size_t>(capacity, rewrite.slots.size() - live)) return false;
            live += _extents[block];
            if (rewrite.extents[b] > capacity) return false;
            slots += rewrite.extents[b];
            _extents[block] = rewrite.extents[b];
        }
        needSlots(std::max(live, slots));
        std::vector<bool> isTaken(slots, false);
        for (const std::uint32_t source : rewrite.slots)
        {
            if (source >= slots || isTaken[source]) return false;
            isTaken[source] = true;
        }
        return live == rewrite.slots.size();
    }

    void needSlots(std::size_t slots)
    {
        _needs.slotsMoved = std::max(_needs.slotsMoved, static_cast<std::uint32_t>(slots));
    }

    const ProgressiveMesh& _progressive;
    RecordWidths _widths;
    std::uint32_t _wedges;
    std::vector<std::uint32_t> _extents;
    PlayerNeeds _needs;
};

} // namespace osgPMObjects::core
