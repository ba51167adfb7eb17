// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>

#include <osgPMObjects/core/progressive/CompactedLevel.h>

#include "IndexPacket.h"

namespace osgPMObjects
{

/// A level that was not played to. Threads: immutable once made.
struct JumpedLevel
{
    std::uint32_t steps = 0;
    bool isNarrow = true;
    std::vector<core::SlotRange> groups; ///< the triangles of each, one group after the other
    std::vector<std::byte> indices;

    std::uint32_t triangleCount() const
    {
        return groups.empty() ? 0 : groups.back().first + groups.back().count;
    }
    core::Triangle triangle(std::uint32_t index) const;
};

using JumpedLevelPtr = std::shared_ptr<const JumpedLevel>;

/// Makes any level of a shape in one pass. To play all steps of 70 000 faces takes some milliseconds, which a frame in which an object
/// comes into sight near by cannot spare; this takes a tenth of one.
/// Memory: that of core::CompactedLevel, once for all view groups. Threads: any.
class ShapeJumps
{
public:
    explicit ShapeJumps(const core::ProgressiveMesh& progressive) : _level(progressive) {}

    /// As many steps take about as long to play as a jump, with its upload: 75 ns each against 1.3 ns a face.
    static std::uint32_t shortest(const core::ProgressiveMesh& progressive)
    {
        constexpr std::uint32_t kLeast = 1000, kFacesOfStep = 32;
        return std::max(kLeast, progressive.slotCount / kFacesOfStep);
    }

    /// None where all steps together are hardly felt.
    static std::shared_ptr<ShapeJumps> of(const core::ProgressiveMesh& progressive)
    {
        constexpr std::uint32_t kFewJumps = 4;
        return progressive.stepCount > kFewJumps * shortest(progressive)
                   ? std::make_shared<ShapeJumps>(progressive)
                   : nullptr;
    }

    JumpedLevelPtr to(std::uint32_t steps);

private:
    std::mutex _mutex;
    core::CompactedLevel _level;
};

} // namespace osgPMObjects
