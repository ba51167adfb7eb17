// SPDX-License-Identifier: Apache-2.0
// The control of tswap: the same orders of faces, told as tables of all faces instead of cycles.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "StepHead.h"
#include "StepRecord.h"

namespace testsupport
{

/// Writes the records of a progressive mesh anew, with a table in the place of each change by cycles: what is
/// drawn stays bit for bit, what moves is told and played otherwise.
class TableForm
{
public:
    explicit TableForm(const osgPMObjects::core::ProgressiveMesh& cycles)
        : _cycles(cycles), _widths(cycles), _tables(cycles)
    {
    }

    osgPMObjects::core::ProgressiveMesh tables()
    {
        using namespace osgPMObjects::core;
        _tables.records.clear();
        const std::byte* const end = _cycles.records.data() + _cycles.records.size() - kRecordPadding;
        for (const std::byte* at = _cycles.records.data(); at != end;)
            at = writeRecord(at);
        _tables.records.resize(_tables.records.size() + kRecordPadding);
        return _tables;
    }

    std::size_t changes() const { return _changes; } ///< changes by cycles so far

private:
    using Reader = osgPMObjects::core::ByteReader;

    /// Returns the end of the record that begins at `begin`.
    const std::byte* writeRecord(const std::byte* begin)
    {
        using namespace osgPMObjects::core;
        Reader in(begin);
        StepHead head = StepHead::read<false>(in);
        SlotLists lists(in, _widths.slot);
        for (std::uint32_t gone = 0; gone < head.wedges; ++gone)
            lists.visit(head.nextCount(), [](std::uint32_t) {});
        lists.visit(head.vanished, [](std::uint32_t) {});
        for (std::uint32_t i = 0; i < head.vanished; ++i)
            if (in.byte() == VanishedFace::kPlain) in.skip(3 * _widths.wedge.bytes);
        std::vector<std::byte>& out = _tables.records;
        const std::size_t first = out.size();
        out.insert(out.end(), begin, in.at());
        if (head.facesMove)
        {
            const std::uint32_t count = in.number();
            appendNumber(out, count);
            for (std::uint32_t i = 0; i < count; ++i)
                writeTable(in);
        }
        const std::byte* const end = skipLength(in.at(), static_cast<std::size_t>(in.at() - begin));
        const std::size_t length = out.size() - first;
        appendFixed(out, length, length <= 0xff ? 1 : 4);
        if (length > 0xff) appendFixed(out, 0, 1);
        return end;
    }

    void writeTable(Reader& in)
    {
        using namespace osgPMObjects::core;
        in.number(); // the 0 that tells cycles
        const std::uint32_t block = in.number(), extent = in.number(), shrinks = in.number();
        std::vector<std::uint32_t> sources;
        for (std::uint32_t slot = 0; slot < extent; ++slot)
            sources.push_back(slot);
        readCycle(in, extent, sources);
        for (std::uint32_t others = in.number(); others > 0; --others)
            readCycle(in, extent, sources);
        sources.resize(extent - shrinks);
        std::vector<std::byte>& out = _tables.records;
        appendNumber(out, 1 << 1);
        appendNumber(out, block);
        appendNumber(out, extent);
        appendNumber(out, sources.size());
        std::int64_t expected = 0;
        for (const std::uint32_t source : sources)
        {
            appendDifference(out, source - expected);
            expected = std::int64_t{source} + 1;
        }
        _tables.mostSlotsMoved =
            std::max(_tables.mostSlotsMoved, static_cast<std::uint32_t>(sources.size() + extent));
        ++_changes;
    }

    /// Enters where the faces of a cycle come from.
    static void readCycle(Reader& in, std::uint32_t extent, std::vector<std::uint32_t>& sources)
    {
        using namespace osgPMObjects::core;
        const FixedWidth width(widthFor(extent));
        std::vector<std::uint32_t> slots(in.number());
        for (std::uint32_t& slot : slots)
            slot = in.fixed(width);
        for (std::size_t i = 0; i < slots.size(); ++i)
            sources[slots[i]] = slots[(i + 1) % slots.size()];
    }

    const osgPMObjects::core::ProgressiveMesh& _cycles;
    osgPMObjects::core::RecordWidths _widths;
    osgPMObjects::core::ProgressiveMesh _tables;
    std::size_t _changes = 0;
};

} // namespace testsupport
