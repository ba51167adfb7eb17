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
    double errorTolerancePx = 1.0; ///< τ: refine while the bound exceeds it
    std::uint32_t maxTriangles = std::numeric_limits<std::uint32_t>::max(); ///< never exceeded
    double maxTimeUs = std::numeric_limits<double>::infinity();             ///< thread time for adapting
};

} // namespace viewlod
