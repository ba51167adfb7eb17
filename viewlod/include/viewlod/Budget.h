// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace viewlod
{

/// The budget of one frame. errorTolerancePx asks for detail, the other values limit it. Reaching a limit is
/// not an error: the result reports the screen error that remains.
struct Budget
{
    /// The clock that measures maxTimeUs.
    enum class Clock
    {
        thread,   ///< processor time of this thread: for real time
        modelled, ///< a fixed cost for each operation (Slice.h), the same on every machine: for capture
    };

    double errorTolerancePx = 1.0; ///< τ: refine while the bound exceeds it
    std::uint32_t maxTriangles = std::numeric_limits<std::uint32_t>::max(); ///< never exceeded
    double maxTimeUs =
        std::numeric_limits<double>::infinity(); ///< of refinement; the rest is left for the next frame
    Clock clock = Clock::thread;
};

} // namespace viewlod
