// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <mutex>

#include <osgPMObjects/core/progressive/CompactedLevel.h>

#include "IndexPacket.h"

namespace osgPMObjects
{

/// A level that was made in one pass. Threads: immutable once made.
struct JumpedLevel
{
    std::uint32_t steps = 0;
    bool isNarrow = true;
    std::vector<core::SlotRange> groups; ///< by group, its triangles, one range after the other
    std::vector<std::byte> indices;

    std::uint32_t triangleCount() const
    {
        return groups.empty() ? 0 : groups.back().first + groups.back().count;
    }
    core::Triangle triangle(std::uint32_t index) const;
};

using JumpedLevelPtr = std::shared_ptr<const JumpedLevel>;

/// Makes any level of a shape in one pass. Applying all steps of 70 000 faces takes some milliseconds, too
/// long for the frame in which an object comes into sight near by; one pass takes a tenth of a millisecond.
/// Memory: that of core::CompactedLevel, once for all view groups. Threads: any.
class ShapeJumps
{
public:
    explicit ShapeJumps(const core::ProgressiveMesh& progressive) : _level(progressive) {}

    /// Returns how many steps take as long to apply as one pass and its upload: 75 ns a step, 1.3 ns a face.
    static std::uint32_t shortest(const core::ProgressiveMesh& progressive)
    {
        constexpr std::uint32_t kLeast = 1000, kFacesOfStep = 32;
        return std::max(kLeast, progressive.slotCount / kFacesOfStep);
    }

    /// Returns null for a shape with so few steps that all together take no noticeable time.
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
