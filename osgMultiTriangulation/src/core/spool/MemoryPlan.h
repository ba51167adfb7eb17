// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include <foundation/Result.h>

#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/spool/SurfaceSpool.h>

namespace osgMultiTriangulation::core
{

/// How a build keeps within a limit of memory.
struct MemoryPlan
{
    std::uint32_t treeCount = 1;  ///< rectangles; does not depend on the threads
    std::uint64_t mostHidden = 0; ///< points that a part keeps of those hidden below it
    unsigned jobs = 1;            ///< threads for which there is room
};

/// Chooses rectangles so small that one part after the other fits: the balanced number of them, or more. A
/// part is a rectangle with the borders that were joined, about 8·√N points.
/// `limitMb`: of the whole process; 0: none, then the balanced number and all hidden points. Errors: no
/// number of rectangles fits; tells the least limit that would do.
/// The border model of `options` is taken as it is.
foundation::Result<MemoryPlan> planMemory(std::uint64_t points, const ForestOptions& options, double limitMb);

/// The same for a surface in files; its border model is fitted where `options` have none and leave the number
/// of rectangles open. Errors: those of fitBorder(), too.
foundation::Result<MemoryPlan> planMemory(const SurfaceSpool& spool, const ForestOptions& options,
                                          double limitMb);

} // namespace osgMultiTriangulation::core
