// SPDX-License-Identifier: Apache-2.0
#include "RecordPacking.h"

#include <numeric>
#include <vector>

#include <osgPMObjects/core/progressive/CheckedReader.h>

#include "CyclesRecord.h"
#include "StepRecord.h"

namespace osgPMObjects::core
{

namespace
{

/// Copies records, from memory to files or back.
class RecordTranscriber
{
public:
    RecordTranscriber(const ProgressiveMesh& progressive, std::span<const std::byte> from, bool packs)
        : _widths(progressive),
          _in(from.data(), from.data() + from.size()),
          _end(from.data() + from.size()),
          _shrinksLeft(progressive.slotCount),
          _packs(packs)
    {
    }

    /// Copies the next record; false: there is none.
    bool copyRecord()
    {
        const std::byte* const begin = _in.at();
        const std::size_t outBefore = _out.size();
        const std::uint32_t head = _in.byte();
        if (!skipFaces(head)) return false;
        _out.insert(_out.end(), begin, _in.at());
        if (head & 0x80 && !copyRearrangements()) return false;
        if (!_packs) appendLengthOfRecord(_out, _out.size() - outBefore);
        if (_packs) skip(static_cast<std::size_t>(skipLength(_in.at(), _in.at() - begin) - _in.at()));
        return _in.isGood();
    }

    bool isAtEnd() const { return _in.at() == _end; }

    std::string text() const { return {reinterpret_cast<const char*>(_out.data()), _out.size()}; }

private:
    /// Whether so many numbers may follow: each takes a byte at least.
    bool hasRoomFor(std::uint64_t count) const
    {
        return _in.isGood() && count <= static_cast<std::uint64_t>(_end - _in.at());
    }

    void skip(std::size_t bytes)
    {
        for (std::size_t i = 0; i < bytes; ++i)
            _in.byte();
    }

    /// Skips what follows the head up to the moves.
    bool skipFaces(std::uint32_t head)
    {
        std::uint32_t vanished = head & 3, patched = head >> 2 & 15;
        if (vanished == 3) vanished = _in.number();
        if (patched == 15) patched = _in.number();
        std::vector<std::uint32_t> lists{patched};
        if (head & 0x40)
        {
            const std::uint32_t wedges = _in.number();
            if (!hasRoomFor(wedges)) return false;
            lists.clear();
            for (std::uint32_t i = 0; i < wedges; ++i)
                lists.push_back(_in.number());
        }
        lists.push_back(vanished);
        SlotLists slots(_in, _widths.slot);
        for (const std::uint32_t count : lists)
        {
            if (!hasRoomFor(count)) return false;
            slots.visit(count, [](std::uint32_t) {});
        }
        if (!hasRoomFor(vanished)) return false;
        for (std::uint32_t i = 0; i < vanished; ++i)
            if (_in.byte() == VanishedFace::kPlain) skip(3 * static_cast<std::size_t>(_widths.wedge.bytes));
        return _in.isGood();
    }

    bool copyRearrangements()
    {
        const std::uint32_t count = _in.number();
        if (!hasRoomFor(count)) return false;
        appendNumber(_out, count);
        for (std::uint32_t i = 0; i < count; ++i)
        {
            const std::byte* const begin = _in.at();
            const std::uint32_t head = _in.number();
            if (head == 0 ? !copyCycles() : !(head & 1 ? skipChain(head >> 1) : skipRewrite(head >> 1)))
                return false;
            if (head != 0) _out.insert(_out.end(), begin, _in.at());
        }
        return _in.isGood();
    }

    bool skipChain(std::uint32_t moves)
    {
        _in.number();
        _in.fixed(_widths.slot);
        return skipNumbers(moves);
    }

    bool skipRewrite(std::uint32_t blocks)
    {
        if (!skipNumbers(std::uint64_t{2} * blocks)) return false;
        return skipNumbers(_in.number());
    }

    bool skipNumbers(std::uint64_t count)
    {
        if (!hasRoomFor(count)) return false;
        for (std::uint64_t i = 0; i < count; ++i)
            _in.number();
        return _in.isGood();
    }

    bool copyCycles()
    {
        CycleSlots change;
        change.block = _in.number();
        const bool isTable = !_packs && change.block & 1;
        if (!_packs) change.block >>= 1;
        change.extent = _in.number();
        const std::uint32_t number = _in.number();
        if (!_in.isGood() || number > change.extent) return false;
        const std::uint32_t shrinks = isTable ? change.extent - number : number;
        if (_packs) return readCycles(change, shrinks) && (appendPacked(change), true);
        if (!isTable) return copyCycleLists(change, shrinks);
        if (shrinks > _shrinksLeft || !hasRoomFor(change.extent - shrinks)) return false;
        _shrinksLeft -= shrinks;
        change.sources.resize(change.extent - shrinks);
        return readTable(change) && (appendCycleSlots(_out, change), true);
    }

    /// Copies cycles that are in a file as they are in memory.
    bool copyCycleLists(const CycleSlots& change, std::uint32_t shrinks)
    {
        for (const std::uint32_t number : {0u, change.block, change.extent, shrinks})
            appendNumber(_out, number);
        const std::byte* const begin = _in.at();
        const auto width = static_cast<std::uint64_t>(widthFor(change.extent));
        const auto skipCycle = [&]
        {
            const std::uint64_t bytes = width * _in.number();
            if (!hasRoomFor(bytes)) return false;
            skip(bytes);
            return true;
        };
        if (!skipCycle()) return false;
        const std::uint32_t others = _in.number();
        for (std::uint32_t i = 0; i < others; ++i)
            if (!skipCycle()) return false;
        _out.insert(_out.end(), begin, _in.at());
        return _in.isGood();
    }

    /// Reads the cycles of a change as a table.
    bool readCycles(CycleSlots& change, std::uint32_t shrinks)
    {
        std::vector<std::uint32_t> sources(change.extent);
        std::iota(sources.begin(), sources.end(), 0u);
        std::vector<bool> isSeen(change.extent, false);
        const FixedWidth width(widthFor(change.extent));
        const auto readCycle = [&]
        {
            const std::uint32_t count = _in.number();
            if (!hasRoomFor(count)) return false;
            std::vector<std::uint32_t> slots;
            for (std::uint32_t i = 0; i < count; ++i)
            {
                const std::uint32_t slot = slots.emplace_back(_in.fixed(width));
                if (slot >= change.extent || isSeen[slot]) return false;
                isSeen[slot] = true;
            }
            for (std::size_t i = 0; i < slots.size(); ++i)
                sources[slots[i]] = slots[i + 1 < slots.size() ? i + 1 : 0];
            return _in.isGood();
        };
        if (!readCycle()) return false;
        const std::uint32_t others = _in.number();
        if (!hasRoomFor(others)) return false;
        for (std::uint32_t i = 0; i < others; ++i)
            if (!readCycle()) return false;
        change.sources.assign(sources.begin(), sources.end() - shrinks);
        return true;
    }

    bool readTable(CycleSlots& change)
    {
        if (!hasRoomFor(change.sources.size())) return false;
        std::vector<bool> isSeen(change.extent, false);
        std::uint32_t expected = 0;
        for (std::uint32_t& source : change.sources)
        {
            source = expected + static_cast<std::uint32_t>(_in.difference());
            if (source >= change.extent || isSeen[source]) return false;
            isSeen[source] = true;
            expected = source + 1;
        }
        return _in.isGood();
    }

    void appendPacked(const CycleSlots& change)
    {
        std::vector<std::byte> table, cycles;
        std::int64_t expected = 0;
        for (const std::uint32_t source : change.sources)
        {
            appendDifference(table, source - expected);
            expected = std::int64_t{source} + 1;
        }
        appendCycleLists(cycles, change);
        const bool isTable = table.size() < cycles.size();
        appendNumber(_out, 0);
        appendNumber(_out, std::uint64_t{change.block} << 1 | (isTable ? 1 : 0));
        appendNumber(_out, change.extent);
        appendNumber(_out, isTable ? change.sources.size() : change.extent - change.sources.size());
        const std::vector<std::byte>& shorter = isTable ? table : cycles;
        _out.insert(_out.end(), shorter.begin(), shorter.end());
    }

    RecordWidths _widths;
    CheckedReader _in;
    const std::byte* _end;
    std::vector<std::byte> _out;
    std::uint32_t _shrinksLeft; ///< by how much tables may still shrink blocks: by each slot once
    bool _packs;
};

bool isWidth(int bytes)
{
    return bytes >= 1 && bytes <= 4;
}

} // namespace

std::string packedRecords(const ProgressiveMesh& progressive, std::span<const std::byte> records)
{
    RecordTranscriber transcriber(progressive, records, true);
    while (!transcriber.isAtEnd() && transcriber.copyRecord())
        ;
    return transcriber.text();
}

std::optional<std::string> unpackedRecords(const ProgressiveMesh& progressive, std::string_view packed,
                                           std::uint32_t steps)
{
    if (!isWidth(progressive.slotBytes) || !isWidth(progressive.wedgeBytes)) return std::nullopt;
    const auto* const bytes = reinterpret_cast<const std::byte*>(packed.data());
    RecordTranscriber transcriber(progressive, {bytes, packed.size()}, false);
    for (std::uint32_t i = 0; i < steps; ++i)
        if (transcriber.isAtEnd() || !transcriber.copyRecord()) return std::nullopt;
    if (!transcriber.isAtEnd()) return std::nullopt;
    return transcriber.text();
}

} // namespace osgPMObjects::core
