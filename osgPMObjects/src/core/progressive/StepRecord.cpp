// SPDX-License-Identifier: Apache-2.0
#include "StepRecord.h"

#include <algorithm>

#include "CyclesRecord.h"

namespace osgPMObjects::core
{

namespace
{

using RecordBytes = std::vector<std::byte>;

/// Writes the slots of a chain: the first in full, then differences.
class ChainWriter
{
public:
    ChainWriter(RecordBytes& bytes, int width) : _bytes(bytes), _width(width) {}

    void write(std::uint32_t slot)
    {
        if (_isFirst)
            appendFixed(_bytes, slot, _width);
        else
            appendDifference(_bytes, static_cast<std::int64_t>(slot) - _last);
        _isFirst = false;
        _last = slot;
    }

private:
    RecordBytes& _bytes;
    int _width;
    bool _isFirst = true;
    std::int64_t _last = 0;
};

/// Returns the byte of VanishedFace, or kPlain if no patched face has the third wedge.
std::uint32_t codeOf(const Triangle& vanished, const StepRecord& step, std::span<const Triangle> patched,
                     std::uint32_t wedges, const std::vector<std::uint32_t>& parents)
{
    std::uint32_t index = 0;
    for (std::uint32_t gone = 0; gone < step.patchedOfWedge.size(); ++gone)
    {
        const std::uint32_t from = wedges - 1 - gone;
        const auto corner = std::find(vanished.begin(), vanished.end(), from) - vanished.begin();
        for (std::uint32_t i = 0; i < step.patchedOfWedge[gone]; ++i, ++index)
        {
            if (corner == 3 || index >= VanishedFace::kPatched) continue;
            for (std::uint32_t c = 0; c < 3; ++c)
            {
                const std::uint32_t third = patched[index][c];
                const std::uint32_t next = vanished[(corner + 1) % 3], last = vanished[(corner + 2) % 3];
                const bool isNext = third == next && last == parents[from];
                if (!isNext && (third != last || next != parents[from])) continue;
                return VanishedFace::code({static_cast<std::uint8_t>(index), static_cast<std::uint8_t>(c),
                                           static_cast<std::uint8_t>(corner),
                                           static_cast<std::uint8_t>((corner + (isNext ? 1 : 2)) % 3)});
            }
        }
    }
    return VanishedFace::kPlain;
}

void appendChain(RecordBytes& bytes, const Rearrangement& chain, int slotWidth)
{
    appendNumber(bytes, (chain.slots.size() - 1) << 1 | 1);
    appendNumber(bytes, chain.blocks.front());
    ChainWriter slots(bytes, slotWidth);
    for (const std::uint32_t slot : chain.slots)
        slots.write(slot);
}

void appendRewrite(RecordBytes& bytes, const Rearrangement& rewrite, std::span<const SlotBlock> blocks)
{
    appendNumber(bytes, rewrite.blocks.size() << 1);
    for (std::size_t b = 0; b < rewrite.blocks.size(); ++b)
        appendNumber(bytes, b == 0 ? rewrite.blocks[0] : rewrite.blocks[b] - rewrite.blocks[b - 1]);
    for (const std::uint32_t extent : rewrite.extents)
        appendNumber(bytes, extent);
    appendNumber(bytes, rewrite.slots.size());
    std::int64_t expected = 0;
    for (const std::uint32_t slot : rewrite.slots)
    {
        std::int64_t inWindow = 0; // slots of the blocks before, up to their extents
        for (std::size_t b = 0; b < rewrite.blocks.size(); ++b)
        {
            const std::uint32_t first = blocks[rewrite.blocks[b]].first;
            if (slot >= first && slot - first < rewrite.extents[b])
            {
                inWindow += slot - first;
                break;
            }
            inWindow += rewrite.extents[b];
        }
        appendDifference(bytes, inWindow - expected);
        expected = inWindow + 1;
    }
}

/// Appends the cycles of a change, whose slots count from the first of the block on.
void appendCycles(RecordBytes& bytes, const Rearrangement& change, std::span<const SlotBlock> blocks)
{
    CycleSlots slots{change.blocks.front(), change.extents.front(), change.slots};
    for (std::uint32_t& source : slots.sources)
        source -= blocks[slots.block].first;
    appendCycleSlots(bytes, slots);
}

void appendHead(RecordBytes& bytes, const StepRecord& step)
{
    const std::size_t vanished = std::min<std::size_t>(step.vanished.size(), 3);
    const std::size_t patched = std::min<std::size_t>(step.patched.size(), 15);
    const bool severalGo = step.patchedOfWedge.size() > 1;
    bytes.push_back(static_cast<std::byte>(vanished | patched << 2 | (severalGo ? 0x40 : 0) |
                                           (step.rearrangements.empty() ? 0 : 0x80)));
    if (vanished == 3) appendNumber(bytes, step.vanished.size());
    if (patched == 15) appendNumber(bytes, step.patched.size());
    if (!severalGo) return;
    appendNumber(bytes, step.patchedOfWedge.size());
    for (const std::uint32_t count : step.patchedOfWedge)
        appendNumber(bytes, count);
}

/// Appends the lists of slots, each ascending: patched faces by removed wedge, then vanished faces.
void appendLists(RecordBytes& bytes, const StepRecord& step, int slotWidth)
{
    std::int64_t firstOfList = -1;
    const auto append = [&](std::span<const std::uint32_t> list)
    {
        if (list.empty()) return;
        if (firstOfList < 0)
            appendFixed(bytes, list.front(), slotWidth);
        else
            appendDifference(bytes, list.front() - firstOfList);
        firstOfList = list.front();
        for (std::size_t i = 1; i < list.size(); ++i)
            appendNumber(bytes, list[i] - list[i - 1]);
    };
    std::span<const std::uint32_t> patched = step.patched;
    for (const std::uint32_t count : step.patchedOfWedge)
    {
        append(patched.first(count));
        patched = patched.subspan(count);
    }
    append(step.vanished);
}

} // namespace

void appendRecord(ProgressiveMesh& progressive, const StepRecord& step,
                  std::span<const Triangle> patchedTriangles, std::uint32_t wedges,
                  std::span<const SlotBlock> blocks)
{
    RecordBytes& bytes = progressive.records;
    const std::size_t begin = bytes.size();
    const RecordWidths widths(progressive);
    appendHead(bytes, step);
    appendLists(bytes, step, widths.slot.bytes);
    for (const Triangle& vanished : step.vanishedTriangles)
    {
        const std::uint32_t code = codeOf(vanished, step, patchedTriangles, wedges, progressive.parents);
        appendFixed(bytes, code, 1);
        if (code != VanishedFace::kPlain) continue;
        for (const std::uint32_t wedge : vanished)
            appendFixed(bytes, wedge, widths.wedge.bytes);
    }
    if (!step.rearrangements.empty()) appendNumber(bytes, step.rearrangements.size());
    for (const Rearrangement& rearrangement : step.rearrangements)
        switch (rearrangement.kind)
        {
        case RearrangementKind::chain:
            appendChain(bytes, rearrangement, widths.slot.bytes);
            break;
        case RearrangementKind::rewrite:
            appendRewrite(bytes, rearrangement, blocks);
            break;
        case RearrangementKind::cycles:
            appendCycles(bytes, rearrangement, blocks);
        }
    appendLengthOfRecord(bytes, bytes.size() - begin);
}

} // namespace osgPMObjects::core
