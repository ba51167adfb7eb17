// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveMesh.h>

namespace osgPMObjects::core
{

/// Slots of an index buffer in a row. Slot s has the indices 3 s, 3 s + 1 and 3 s + 2.
struct SlotRange
{
    std::uint32_t first = 0, count = 0;
    bool operator==(const SlotRange&) const = default;
};

/// What steps have done to an index buffer so far.
struct StepStatistics
{
    std::uint64_t steps = 0;         ///< either way
    std::uint64_t facesPatched = 0;  ///< got another wedge at a corner
    std::uint64_t facesVanished = 0; ///< became a hole, or came back from one
    std::uint64_t facesMoved = 0;    ///< into another slot
};

/// The index buffer of one level of a progressive mesh, which is changed in place when the level changes.
/// Begins with the coarsest level. What it holds depends on the level alone, not on the way there. A hole's three indices are equal: a triangle without area.
/// Memory: that of the indices, 16-bit ones if there are fewer than 65 536 wedges, and the largest rearrangement's. Nothing is
/// allocated after construction. Cost of a change: the steps between; no more than that of a step where nothing changes.
/// Threads: one at a time. The mesh has to outlive it, and must not change.
class ProgressiveLevel
{
public:
    explicit ProgressiveLevel(const ProgressiveMesh& progressive);
    ~ProgressiveLevel();
    ProgressiveLevel(ProgressiveLevel&&) noexcept;
    ProgressiveLevel& operator=(ProgressiveLevel&&) noexcept;

    /// Makes the level after so many steps; at most as many as there are.
    void moveTo(std::uint32_t steps);

    std::uint32_t steps() const;
    std::uint32_t faceCount() const;
    std::uint32_t wedgeCount() const; ///< vertices of the buffer that the level may use: the first

    bool hasNarrowIndices() const;
    std::span<const std::uint16_t> narrowIndices() const; ///< empty if there are too many wedges
    std::span<const std::uint32_t> wideIndices() const;   ///< empty if 16 bits do

    /// The face in a slot; of a hole, equal corners.
    Triangle face(std::uint32_t slot) const;

    /// What to draw of a group of faces, in order, appended to a list.
    void appendRanges(std::uint32_t group, std::vector<SlotRange>& ranges) const;

    /// The slots that were written since the last call, roughly, appended to a list in order; everything at first.
    void takeChanges(std::vector<SlotRange>& changes);

    const StepStatistics& statistics() const;

    class Player; ///< for 16- or 32-bit indices

private:
    std::unique_ptr<Player> _player;
};

} // namespace osgPMObjects::core
