// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <osgMultiTriangulation/core/split/Partition.h>

namespace osgMultiTriangulation::core
{

/// Jobs with consecutive numbers that need each other's results in no case, only those of earlier steps.
struct JobStep
{
    std::uint32_t first = 0, count = 0;
};

/// The parts of a partition as numbered jobs: rectangles first, then step by step the parts that join them;
/// the last is the whole.
struct JobOrder
{
    std::vector<std::uint32_t> partOf; ///< by job
    std::vector<std::uint32_t> jobOf;  ///< by part
    std::vector<JobStep> steps;
};

JobOrder jobOrder(const Partition& partition);

} // namespace osgMultiTriangulation::core
