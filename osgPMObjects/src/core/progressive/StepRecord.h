// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "Bytes.h"
#include "SlotTable.h"

namespace osgPMObjects::core
{

/// One step, as it stands in ProgressiveMesh::records, from the finer level to the coarser:
///
///     head        byte: vanished faces (2 bits, 3: a number follows), patched faces (4 bits, 15: a number follows), whether several
///                 wedges go, whether faces move
///     [numbers]   of vanished faces; of patched faces; of wedges that go, with those patched of each
///     slots       of the patched faces, by wedge that goes, the last wedge first, then of the vanished ones; each list rises. The very first
///                 in as many bytes as slots need, the first of another list as the difference from that of the list before, all others as
///                 differences
///     vanished    for each a byte: how to find its corners again among those of the patched faces (VanishedFace), or 255
///                 and its three wedges
///     [moves]     how many rearrangements, and these
///     length      of all this in one byte; or four, and a byte 0
///
/// The wedges that go are the last ones; what each becomes says ProgressiveMesh::parents.
struct StepRecord
{
    std::vector<std::uint32_t> patchedOfWedge; ///< by wedge that goes, the last first
    std::vector<std::uint32_t> patched;        ///< slots
    std::vector<std::uint32_t> vanished;       ///< slots
    std::vector<Triangle> vanishedTriangles;
    std::vector<Rearrangement> rearrangements;
};

/// A vanished face has the wedge that goes, the one that it becomes, and a third, which as a rule is a corner of a patched face, too.
struct VanishedFace
{
    static constexpr std::uint32_t kPlain = 255;
    static constexpr std::uint32_t kCodesOfPatched = 18, kPatched = kPlain / kCodesOfPatched;

    std::uint8_t patched; ///< which patched face has the third wedge
    std::uint8_t corner;  ///< and where
    std::uint8_t from;    ///< corner of the wedge that goes
    std::uint8_t third;   ///< corner of the third wedge

    /// Three corners of the patched face, and six ways in which the three corners lie.
    static constexpr std::uint32_t code(const VanishedFace& face)
    {
        return face.patched * kCodesOfPatched + face.corner * 6u + face.from * 2u +
               (face.third == (face.from + 1) % 3 ? 1u : 0u);
    }

    static constexpr VanishedFace ofCode(std::uint32_t code)
    {
        const std::uint32_t from = code % 6 / 2, third = (from + (code & 1 ? 1 : 2)) % 3;
        return {static_cast<std::uint8_t>(code / kCodesOfPatched),
                static_cast<std::uint8_t>(code % kCodesOfPatched / 6), static_cast<std::uint8_t>(from),
                static_cast<std::uint8_t>(third)};
    }
};

/// Bytes behind the last record, so that numbers can be read four bytes at a time.
constexpr std::size_t kRecordPadding = 4;

/// How wide numbers are in the records of a mesh.
struct RecordWidths
{
    FixedWidth slot, wedge;

    explicit RecordWidths(const ProgressiveMesh& progressive)
        : slot(progressive.slotBytes), wedge(progressive.wedgeBytes)
    {
    }
};

/// The end of a record whose length begins here.
inline const std::byte* skipLength(const std::byte* length, std::size_t bytes)
{
    return length + (bytes <= 0xff ? 1 : 5);
}

/// Where the record begins that ends here.
inline const std::byte* beginOfRecordBefore(const std::byte* end)
{
    const auto length = static_cast<std::uint32_t>(end[-1]);
    if (length != 0) [[likely]]
        return end - 1 - length;
    return end - 5 - ByteReader(end - 5).fixed(FixedWidth(4));
}

/// Reads the lists of slots.
template<class Reader>
class SlotLists
{
public:
    SlotLists(Reader& in, const FixedWidth& slotWidth) : _in(in), _slotWidth(slotWidth) {}

    /// Calls visit(slot) for the next list, of `count` slots.
    template<class Visit>
    void visit(std::uint32_t count, const Visit& visit)
    {
        if (count == 0) return;
        _firstOfList = _isFirst ? _in.fixed(_slotWidth) : _firstOfList + _in.difference();
        _isFirst = false;
        std::uint32_t slot = _firstOfList;
        visit(slot);
        for (std::uint32_t i = 1; i < count; ++i)
            visit(slot += _in.number());
    }

private:
    Reader& _in;
    FixedWidth _slotWidth;
    bool _isFirst = true;
    std::uint32_t _firstOfList = 0;
};

/// Appends a step. `patchedTriangles`: of the patched faces, after it. `wedges`: how many there are before it.
void appendRecord(ProgressiveMesh& progressive, const StepRecord& step,
                  std::span<const Triangle> patchedTriangles, std::uint32_t wedges,
                  std::span<const SlotBlock> blocks);

} // namespace osgPMObjects::core
