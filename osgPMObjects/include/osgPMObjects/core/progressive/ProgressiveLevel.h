// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// A range of consecutive slots of an index buffer. Slot s has the indices 3 s, 3 s + 1 and 3 s + 2.
struct SlotRange
{
    std::uint32_t first = 0, count = 0;
    bool operator==(const SlotRange&) const = default;
};

/// Counts what steps have done to an index buffer since its construction.
struct StepStatistics
{
    std::uint64_t steps = 0;         ///< in either direction
    std::uint64_t facesPatched = 0;  ///< faces that got another wedge at a corner
    std::uint64_t facesVanished = 0; ///< faces that became a hole, or came back from one
    std::uint64_t facesMoved = 0;    ///< faces that moved to another slot
};

/// The index buffer of one level of a progressive mesh; a change of level edits it in place. It begins at the
/// coarsest level. Its contents depend on the level alone, not on the levels before. A *hole* is a slot with
/// three equal indices, a triangle without area.
/// Memory: the indices (16-bit with fewer than 65 536 wedges, else 32-bit) and the largest rearrangement;
/// allocated by the constructor only. Cost of a change: linear in the steps between the levels and in what
/// they change.
/// Threads: one at a time. The mesh must outlive this object and must not change.
class ProgressiveLevel
{
public:
    explicit ProgressiveLevel(const ProgressiveMesh& progressive);
    ~ProgressiveLevel();
    ProgressiveLevel(ProgressiveLevel&&) noexcept;
    ProgressiveLevel& operator=(ProgressiveLevel&&) noexcept;

    /// Plays steps until `steps` of them lead here from the finest level; `steps` ≤
    /// ProgressiveMesh::stepCount.
    void moveTo(std::uint32_t steps);

    std::uint32_t steps() const;
    std::uint32_t faceCount() const;
    std::uint32_t wedgeCount() const; ///< the level uses this many vertices, the first of the buffer

    bool hasNarrowIndices() const;
    std::span<const std::uint16_t> narrowIndices() const; ///< empty with 32-bit indices
    std::span<const std::uint32_t> wideIndices() const;   ///< empty with 16-bit indices

    /// Returns the face in a slot; a hole has equal corners.
    Triangle face(std::uint32_t slot) const;

    /// Appends the slots to draw of one group of faces, in order.
    void appendRanges(std::uint32_t group, std::vector<SlotRange>& ranges) const;

    /// Appends the slots written since the last call, in order, rounded up to blocks of slots; all slots at
    /// the first call.
    void takeChanges(std::vector<SlotRange>& changes);

    const StepStatistics& statistics() const;

    class Player; ///< implements both widths of indices

private:
    std::unique_ptr<Player> _player;
};

} // namespace osgPMObjects::core
