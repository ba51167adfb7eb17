// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/HeightFit.h"

#include <ranges>

namespace scenery
{

namespace
{

constexpr int kMostPasses = 500;
constexpr double kLeastChangeM = 1e-9;

/// Lowers `height` to `mostM` if it lies above, and says so.
bool lower(double& height, double mostM)
{
    if (height <= mostM + kLeastChangeM) return false;
    height = mostM;
    return true;
}

bool lowerBoth(std::vector<double>& heights, const HeightStep& step)
{
    const bool isToLower = lower(heights[step.to], heights[step.from] + step.mostM);
    return lower(heights[step.from], heights[step.to] - step.leastM) || isToLower;
}

/// The greatest heights that are nowhere above the wishes and keep every step.
std::vector<double> lowered(std::vector<double> heights, const std::vector<HeightStep>& steps)
{
    for (int pass = 0; pass < kMostPasses; ++pass)
    {
        bool isChanged = false;
        for (const HeightStep& step : steps)
            isChanged = lowerBoth(heights, step) || isChanged;
        for (const HeightStep& step : std::views::reverse(steps))
            isChanged = lowerBoth(heights, step) || isChanged;
        if (!isChanged) break;
    }
    return heights;
}

} // namespace

std::vector<double> fitHeights(const std::vector<double>& wishesM, const std::vector<HeightStep>& steps)
{
    // The least heights above the wishes are the greatest below them, upside down.
    std::vector<HeightStep> mirrored = steps;
    for (HeightStep& step : mirrored)
        step = {step.from, step.to, -step.mostM, -step.leastM};
    std::vector<double> mirroredWishes = wishesM;
    for (double& wish : mirroredWishes)
        wish = -wish;
    std::vector<double> heights = lowered(wishesM, steps);
    const std::vector<double> raised = lowered(std::move(mirroredWishes), mirrored);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 0.5 * (heights[i] - raised[i]);
    return heights;
}

} // namespace scenery
