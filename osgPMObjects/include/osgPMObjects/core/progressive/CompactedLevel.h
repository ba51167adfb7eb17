// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// The faces of any level of a progressive mesh, made in one pass over all faces: those that are left, without holes, in
/// the order that they have at the finest level. For levels far from each other, and for such as stay.
/// Indices are as wide as those of ProgressiveLevel.
/// Memory: 14 B a face and 2 B a wedge with narrow indices, twice that with wide ones. Nothing is allocated after construction.
/// Cost: linear in the finest level, however far the levels are apart; to construct one, that of playing all steps.
/// Threads: one at a time. The mesh has to outlive it, and must not change.
/// Source: "compaction" in Forsyth, "Comparison of VIPM methods" (2001), §4 (skip strips).
class CompactedLevel
{
public:
    explicit CompactedLevel(const ProgressiveMesh& progressive);
    ~CompactedLevel();
    CompactedLevel(CompactedLevel&&) noexcept;
    CompactedLevel& operator=(CompactedLevel&&) noexcept;

    /// Makes the level after so many steps; at most as many as there are.
    void moveTo(std::uint32_t steps);

    bool hasNarrowIndices() const;
    /// Three indices a triangle, group by group; empty where indices are of the other width.
    std::span<const std::uint16_t> narrowIndices() const;
    std::span<const std::uint32_t> wideIndices() const;

    std::uint32_t triangleCount() const;
    Triangle triangle(std::uint32_t index) const;
    std::uint32_t groupCount() const;
    /// What triangles a group of faces has.
    SlotRange rangeOf(std::uint32_t group) const;

    class Pass; ///< one for each width of indices

private:
    std::unique_ptr<Pass> _pass;
};

} // namespace osgPMObjects::core
