// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace osgPMObjects::core
{

/// Faces in the slots of an index buffer. Slots belong to blocks; a block is drawn from its first slot to its *extent*, and what is
/// behind that is unused. A face that vanishes leaves a hole where it was; a rearrangement closes holes.
struct SlotBlock
{
    std::uint32_t group = 0; ///< whose faces it has: those of one material
    std::uint32_t first = 0; ///< slot
    std::uint32_t capacity = 0;
    std::uint32_t extent = 0; ///< slots that are drawn, holes among them
    std::uint32_t live = 0;
};

/// How faces move. A *chain* is the paper's tswap: what is in slots[i + 1] goes to slots[i], the first of which is a hole; the last is
/// unused afterwards, and the extent of its block one less. Otherwise blocks are filled anew, one after the other, by what is in
/// `slots`; whatever else they had was a hole.
struct Rearrangement
{
    bool isChain = false;
    std::vector<std::uint32_t> blocks;  ///< of a chain: that of its last slot
    std::vector<std::uint32_t> extents; ///< of the blocks, before
    std::vector<std::uint32_t> slots;
};

/// Memory: 8 B a face. Cost: of a rearrangement, the slots that it names.
class SlotTable
{
public:
    static constexpr std::uint32_t kNone = ~0u;

    /// Appends blocks of at most `blockFaces` faces for a group.
    void append(std::uint32_t group, std::span<const std::uint32_t> faces, std::uint32_t blockFaces);

    void bury(std::uint32_t face);
    void chain(std::vector<std::uint32_t> slots);
    /// Chains that put the last face of a block into each of its holes, one after the other. Returns the slots filled.
    std::vector<std::uint32_t> fillHoles(std::uint32_t block);
    /// Fills blocks with all of their faces that are left, which are given in their new order.
    void rewrite(std::vector<std::uint32_t> blocks, std::span<const std::uint32_t> faces);

    const std::vector<SlotBlock>& blocks() const { return _blocks; }
    std::uint32_t blockOf(std::uint32_t slot) const;
    std::uint32_t faceAt(std::uint32_t slot) const { return _faceAt[slot]; } ///< kNone: a hole, or unused
    std::uint32_t slotOf(std::uint32_t face) const { return _slotOf[face]; } ///< of a live one
    std::uint32_t slotCount() const { return static_cast<std::uint32_t>(_faceAt.size()); }

    /// The next block of the same group, before (-1) or after (+1), that has faces left; kNone: there is none.
    std::uint32_t liveNeighbour(std::uint32_t block, int direction) const;

    /// Blocks that faces were buried in since takeRearrangements(), each once.
    const std::vector<std::uint32_t>& buriedIn() const { return _buriedIn; }

    /// The faces of a block that are left, in order, at the end of a list.
    void appendFaces(std::uint32_t block, std::vector<std::uint32_t>& faces) const;

    /// How many faces rearrangements have put into another slot so far.
    std::uint64_t moves() const { return _moves; }

    /// The rearrangements since the last call: those of one step.
    std::vector<Rearrangement> takeRearrangements();

private:
    void put(std::uint32_t face, std::uint32_t slot);

    std::vector<SlotBlock> _blocks;
    std::vector<std::uint32_t> _faceAt; ///< by slot
    std::vector<std::uint32_t> _slotOf; ///< by face
    std::vector<Rearrangement> _rearrangements;
    std::vector<std::uint32_t> _buriedIn;
    std::uint64_t _moves = 0;
};

} // namespace osgPMObjects::core
