// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/progressive/Bytes.h>
#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

#include "SlotTable.h"

namespace osgPMObjects::core
{

/// One step from a level to the next coarser one. Its bytes in ProgressiveMesh::records:
///
///     head        1 byte: vanished faces (2 bits; 3: a number follows), patched faces (4 bits; 15: a number
///                 follows), 1 bit for several removed wedges, 1 bit for moves
///     [numbers]   vanished faces; patched faces; removed wedges and the patched faces of each
///     slots       of the patched faces, by removed wedge from the last on, then of the vanished faces; each
///                 list ascends. The first slot of all has slotBytes; the first of a later list is a
///                 difference to that of the list before; all others are differences to their predecessors
///     vanished    by face: 1 byte that tells how to restore its corners from those of the patched faces
///                 (VanishedFace); or 255 and its three wedges
///     [moves]     the number of rearrangements, then each of them: a chain, a rewrite or cycles
///     length      of the bytes above: 1 byte, or 4 bytes and a byte 0
///
/// The removed wedges are the last ones; ProgressiveMesh::parents tells what replaces them.
struct StepRecord
{
    std::vector<std::uint32_t>
        patchedOfWedge;                  ///< number of patched faces by removed wedge, the last wedge first
    std::vector<std::uint32_t> patched;  ///< slots
    std::vector<std::uint32_t> vanished; ///< slots
    std::vector<Triangle> vanishedTriangles;
    std::vector<Rearrangement> rearrangements;
};

/// The corners of a vanished face, in one byte: the removed wedge, its parent, and a third wedge that most
/// often is also a corner of a patched face.
struct VanishedFace
{
    static constexpr std::uint32_t kPlain = 255;
    static constexpr std::uint32_t kCodesOfPatched = 18, kPatched = kPlain / kCodesOfPatched;

    std::uint8_t patched; ///< number of the patched face that has the third wedge
    std::uint8_t corner;  ///< corner of the patched face with the third wedge
    std::uint8_t from;    ///< corner of the vanished face with the removed wedge
    std::uint8_t third;   ///< corner of the vanished face with the third wedge

    /// Returns the byte: three corners of the patched face times six orders of the vanished face's corners.
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

/// The bytes behind the last record, so that numbers can be read four bytes at a time.
constexpr std::size_t kRecordPadding = 4;

/// The widths of numbers in the records of a mesh.
struct RecordWidths
{
    FixedWidth slot, wedge;

    explicit RecordWidths(const ProgressiveMesh& progressive)
        : slot(progressive.slotBytes), wedge(progressive.wedgeBytes)
    {
    }
};

/// Returns the end of a record whose length field is at `length`.
inline const std::byte* skipLength(const std::byte* length, std::size_t bytes)
{
    return length + (bytes <= 0xff ? 1 : 5);
}

/// Returns the beginning of the record that ends at `end`.
inline const std::byte* beginOfRecordBefore(const std::byte* end)
{
    const auto length = static_cast<std::uint32_t>(end[-1]);
    if (length != 0) [[likely]]
        return end - 1 - length;
    return end - 5 - ByteReader(end - 5).fixed(FixedWidth(4));
}

/// Reads the lists of slots of a record.
template<class Reader>
class SlotLists
{
public:
    SlotLists(Reader& in, const FixedWidth& slotWidth) : _in(in), _slotWidth(slotWidth) {}

    /// Calls visit(slot) for each slot of the next list, which has `count` slots.
    template<class Visit>
    void visit(std::uint32_t count, const Visit& visit)
    {
        if (count > 0) visitSome(count, visit);
    }

    /// Does so for a list that is known to have slots.
    template<class Visit>
    void visitSome(std::uint32_t count, const Visit& visit)
    {
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

/// Appends the record of a step. `patchedTriangles`: patched faces after the step; `wedges`: number of wedges
/// before it.
void appendRecord(ProgressiveMesh& progressive, const StepRecord& step,
                  std::span<const Triangle> patchedTriangles, std::uint32_t wedges,
                  std::span<const SlotBlock> blocks);

} // namespace osgPMObjects::core
