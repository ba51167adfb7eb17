// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>

namespace viewlod
{

/// What a frame may cost. The error target asks for detail, the others limit it; a limit that binds is not
/// an error: the result reports the error reached.
struct Budget
{
    /// What maxTimeUs is measured by.
    enum class Clock
    {
        thread,   ///< the time that this thread has computed: for real time
        modelled, ///< a fixed cost for each step of the work (Slice.h): the same on every machine, for capture
    };

    double errorTolerancePx = 1.0; ///< τ: refine while the bound exceeds it
    std::uint32_t maxTriangles = std::numeric_limits<std::uint32_t>::max(); ///< never exceeded
    double maxTimeUs =
        std::numeric_limits<double>::infinity(); ///< for adapting; the rest goes on in the next frame
    Clock clock = Clock::thread;
};

} // namespace viewlod
