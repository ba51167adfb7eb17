// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "terminal/Report.h"

namespace terraintool
{

/// What the command line of mt_bench asks for.
struct MtBenchRequest
{
    std::vector<std::size_t> points{10'000, 50'000, 100'000, 250'000, 500'000};
    std::string distribution;     ///< one alone; empty: all four
    std::filesystem::path folder; ///< for the files, which are removed again
    double memoryMb = 0.0;        ///< 0: no limit
    osgMultiTriangulation::core::ForestOptions options;
    bool hasSweeps = false; ///< sweeps over the first number of points, instead of the cases
};

/// Builds made-up points of four distributions, and fits how time and borders grow with their number.
foundation::Result<terminal::Report> benchMt(const MtBenchRequest& request);

} // namespace terraintool
