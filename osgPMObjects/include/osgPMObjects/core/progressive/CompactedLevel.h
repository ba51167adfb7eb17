// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <osgPMObjects/core/Triangle.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects::core
{

/// Rebuilds the triangle list of any level of a progressive mesh in one pass over the faces of the finest
/// level. The list has no holes; its faces keep the order of the finest level. It suits large changes of
/// level, and levels that stay for long; ProgressiveLevel suits small changes. Indices have the same width as
/// those of ProgressiveLevel.
/// Memory: 14 B a face and 2 B a wedge with 16-bit indices, twice that with 32-bit ones; allocated by the
/// constructor only.
/// Cost: moveTo() is linear in the faces of the finest level; the constructor plays all steps once.
/// Threads: one at a time. The mesh must outlive this object and must not change.
/// Source: "compaction" in Forsyth, "Comparison of VIPM methods" (2001), §4 (skip strips).
class CompactedLevel
{
public:
    explicit CompactedLevel(const ProgressiveMesh& progressive);
    ~CompactedLevel();
    CompactedLevel(CompactedLevel&&) noexcept;
    CompactedLevel& operator=(CompactedLevel&&) noexcept;

    /// Builds the level that `steps` steps lead to; `steps` ≤ ProgressiveMesh::stepCount.
    void moveTo(std::uint32_t steps);

    bool hasNarrowIndices() const;
    /// Return three indices a triangle, group by group; the span of the other width is empty.
    std::span<const std::uint16_t> narrowIndices() const;
    std::span<const std::uint32_t> wideIndices() const;

    std::uint32_t triangleCount() const;
    Triangle triangle(std::uint32_t index) const;
    std::uint32_t groupCount() const;
    /// Returns the range of triangles of one group of faces.
    SlotRange rangeOf(std::uint32_t group) const;

    class Pass; ///< implements both widths of indices

private:
    std::unique_ptr<Pass> _pass;
};

} // namespace osgPMObjects::core
