// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/split/Partition.h>

namespace osgMultiTriangulation::core
{

/// Tells which parts can be built: halves before the parts that join them.
/// Threads: one.
class PartSchedule
{
public:
    /// `isDone`: by part: needs no work. Empty: none. `partition` must stay.
    explicit PartSchedule(const Partition& partition, const std::vector<bool>& isDone = {});

    bool hasReady() const { return !_ready.empty(); }
    bool isFinished() const { return _done == all(); }
    std::uint32_t done() const { return _done; }
    std::uint32_t all() const { return static_cast<std::uint32_t>(_missing.size()); }

    /// Returns a part that can be built, once; kNone while there is none.
    std::uint32_t take();

    /// A part that was taken is built.
    void finish(std::uint32_t part);

private:
    const Partition& _partition;
    std::vector<std::uint32_t> _missing; ///< by part: halves that are not built
    std::vector<std::uint32_t> _ready;
    std::uint32_t _done = 0;
};

} // namespace osgMultiTriangulation::core
