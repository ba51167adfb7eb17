// SPDX-License-Identifier: Apache-2.0
#include "MemoryPlan.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "SpoolBorder.h"

namespace osgMultiTriangulation::core
{

namespace
{

constexpr double kProgramBytes = 48e6;       ///< program, libraries, buffers of readers
constexpr double kBytesOfPoint = 550.0;      ///< of a part that is built, and its tree
constexpr double kBytesOfHidden = 90.0;      ///< of a hidden point of it
constexpr double kHiddenOfPoint = 4.0;       ///< hidden points that are kept for each point
constexpr double kBytesOfRectangle = 4000.0; ///< two parts: partition, directory, triangles that wait

/// The most points of a part's drain.
double pointsOfPart(double points, double trees)
{
    return std::min(points, 4.0 / 3.0 * points / trees + 8.0 * std::sqrt(points));
}

double bytesOfJob(double points, double trees)
{
    return pointsOfPart(points, trees) * (kBytesOfPoint + kBytesOfHidden * kHiddenOfPoint);
}

double bytesOfAll(double trees)
{
    return kProgramBytes + kBytesOfRectangle * trees;
}

} // namespace

foundation::Result<MemoryPlan> planMemory(std::uint64_t points, const ForestOptions& options, double limitMb)
{
    const auto all = static_cast<double>(points);
    const double limit = limitMb * 1e6;
    double trees = options.treeCount > 0 ? options.treeCount
                                         : balancedTreeCount(all, options.border.value_or(BorderModel{}));
    if (limitMb == 0.0)
        return MemoryPlan{static_cast<std::uint32_t>(trees), std::numeric_limits<std::uint64_t>::max(),
                          options.jobs};
    double least = std::numeric_limits<double>::max();
    while (true)
    {
        const double needed = bytesOfAll(trees) + bytesOfJob(all, trees);
        if (needed <= limit) break;
        least = std::min(least, needed);
        if (options.treeCount > 0 || all / trees < 64.0)
            return foundation::Error{std::to_string(points) + " points",
                                     "need " + std::to_string(std::lround(std::ceil(least / 1e6))) +
                                         " MB at least",
                                     options.treeCount > 0 ? "allow more with --memory, or leave out --trees"
                                                           : "allow more with --memory"};
        trees *= 2.0;
    }
    MemoryPlan plan;
    plan.treeCount = static_cast<std::uint32_t>(trees);
    plan.mostHidden = static_cast<std::uint64_t>(kHiddenOfPoint * pointsOfPart(all, trees));
    const double jobs = (limit - bytesOfAll(trees)) / bytesOfJob(all, trees);
    plan.jobs = static_cast<unsigned>(std::clamp(jobs, 1.0, static_cast<double>(options.jobs)));
    return plan;
}

foundation::Result<MemoryPlan> planMemory(const SurfaceSpool& spool, const ForestOptions& options,
                                          double limitMb)
{
    ForestOptions fitted = options;
    if (options.treeCount == 0 && !options.border)
    {
        const auto model = fitBorder(spool, options.where);
        if (!model) return model.error();
        fitted.border = *model;
    }
    return planMemory(spool.points().size(), fitted, limitMb);
}

} // namespace osgMultiTriangulation::core
