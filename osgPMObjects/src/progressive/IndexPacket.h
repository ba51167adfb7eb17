// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <osgPMObjects/core/progressive/ProgressiveLevel.h>

namespace osgPMObjects
{

/// What one change of level wrote into an index buffer. It is a copy, so the next change may run while this
/// one is drawn. It takes a copy of the buffer from state `serial - 1` to state `serial`, or from nothing if
/// `isWhole`.
/// Threads: immutable once made.
struct IndexPacket
{
    std::uint64_t serial = 0;
    bool isWhole = false;
    std::vector<core::SlotRange> ranges; ///< where `bytes` belong, one range after the other
    std::vector<std::byte> bytes;
};

using IndexPacketPtr = std::shared_ptr<const IndexPacket>;

/// What draws one level of an object: a state of its index buffer and the slots in use.
/// Threads: immutable once made.
struct DrawnLevel
{
    std::uint64_t serial = 0;
    IndexPacketPtr packet; ///< takes the context to that state; null: it has that state
    std::uint32_t steps = 0, faces = 0;
    std::vector<core::SlotRange> ranges;
    std::vector<std::uint32_t> groupEnds; ///< by group, the end of its ranges in `ranges`

    std::span<const core::SlotRange> rangesOf(std::uint32_t group) const
    {
        const std::uint32_t begin = group == 0 ? 0 : groupEnds[group - 1];
        return std::span(ranges).subspan(begin, groupEnds[group] - begin);
    }
};

using DrawnLevelPtr = std::shared_ptr<const DrawnLevel>;

} // namespace osgPMObjects
