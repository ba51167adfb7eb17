// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// A block of consecutive slots of an index buffer. It is drawn from its first slot to its *extent*; the
/// slots behind are unused. A face that vanishes leaves a hole; a rearrangement closes holes.
struct SlotBlock
{
    std::uint32_t group = 0; ///< of faces with one material
    std::uint32_t first = 0; ///< first slot
    std::uint32_t capacity = 0;
    std::uint32_t extent = 0; ///< slots that are drawn, holes included
    std::uint32_t live = 0;
};

/// How a Rearrangement is told and played.
enum class RearrangementKind
{
    /// The face in slots[i + 1] moves to slots[i]; the first slot is a hole before, the last one is unused
    /// afterwards, and the extent of its block shrinks by one.
    chain,
    /// Blocks are filled, one after the other, with the faces of `slots`; their other slots were holes. All
    /// faces are told, as a table.
    rewrite,
    /// The same for one block, told as cycles of the slots that change (SlotCycles): the tswap of Graphicon
    /// 2003.
    cycles,
};

/// A change of the slots of faces.
struct Rearrangement
{
    RearrangementKind kind = RearrangementKind::rewrite;
    std::vector<std::uint32_t> blocks;  ///< of a chain: the block of its last slot
    std::vector<std::uint32_t> extents; ///< of the blocks, before the change
    std::vector<std::uint32_t> slots;
};

/// The faces in the slots of an index buffer, while a progressive mesh is built.
/// Memory: 8 B a face. Cost of a rearrangement: the slots that it names.
class SlotTable
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    /// Appends blocks of at most `blockFaces` faces for a group.
    void append(std::uint32_t group, std::span<const std::uint32_t> faces, std::uint32_t blockFaces);

    void removeFace(std::uint32_t face);
    void chain(std::vector<std::uint32_t> slots);
    /// Fills each hole of a block with its last face, by one chain each. Returns the slots filled.
    std::vector<std::uint32_t> fillHoles(std::uint32_t block);
    /// Refills blocks with all their remaining faces, given in the new order.
    void rewrite(std::vector<std::uint32_t> blocks, std::span<const std::uint32_t> faces);
    /// Does so for one block, by cycles.
    void permute(std::uint32_t block, std::span<const std::uint32_t> faces);

    const std::vector<SlotBlock>& blocks() const { return _blocks; }
    std::uint32_t blockOf(std::uint32_t slot) const;
    std::uint32_t faceAt(std::uint32_t slot) const { return _faceAt[slot]; } ///< kNone: a hole, or unused
    std::uint32_t slotOf(std::uint32_t face) const
    {
        return _slotOf[face];
    } ///< of a face that has not vanished
    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(_faceAt.size()); }

    /// Returns the next block of the same group with faces, before (-1) or after (+1) a block; kNone if there
    /// is none.
    std::uint32_t liveNeighbour(std::uint32_t block, int direction) const;

    /// Returns the blocks that lost faces since takeRearrangements(), each once.
    const std::vector<std::uint32_t>& blocksWithRemovals() const { return _blocksWithRemovals; }

    /// Appends the remaining faces of a block, in order.
    void appendFaces(std::uint32_t block, std::vector<std::uint32_t>& faces) const;

    /// Returns how many faces rearrangements have moved so far.
    std::uint64_t moves() const { return _moves; }

    /// Returns the rearrangements since the last call (those of one step), and forgets them.
    std::vector<Rearrangement> takeRearrangements();

private:
    void put(std::uint32_t face, std::uint32_t slot);
    void refill(RearrangementKind kind, std::vector<std::uint32_t> blocks,
                std::span<const std::uint32_t> faces);

    std::vector<SlotBlock> _blocks;
    std::vector<std::uint32_t> _faceAt; ///< by slot
    std::vector<std::uint32_t> _slotOf; ///< by face
    std::vector<Rearrangement> _rearrangements;
    std::vector<std::uint32_t> _blocksWithRemovals;
    std::uint64_t _moves = 0;
};

} // namespace osgPMObjects::core
