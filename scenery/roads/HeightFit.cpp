// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/HeightFit.h"

#include <algorithm>
#include <cmath>

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
        for (auto step = steps.rbegin(); step != steps.rend(); ++step)
            isChanged = lowerBoth(heights, *step) || isChanged;
        if (!isChanged) break;
    }
    return heights;
}

/// The same steps, and heights, upside down.
std::vector<HeightStep> mirroredSteps(std::vector<HeightStep> steps)
{
    for (HeightStep& step : steps)
        step = {step.from, step.to, -step.mostM, -step.leastM};
    return steps;
}

} // namespace

std::vector<double> fitHeights(const std::vector<double>& wishesM, const std::vector<HeightStep>& steps)
{
    // The least heights above the wishes are the greatest below them, upside down.
    const std::vector<HeightStep> mirrored = mirroredSteps(steps);
    std::vector<double> mirroredWishes = wishesM;
    for (double& wish : mirroredWishes)
        wish = -wish;
    std::vector<double> heights = lowered(wishesM, steps);
    const std::vector<double> raised = lowered(std::move(mirroredWishes), mirrored);
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] = 0.5 * (heights[i] - raised[i]);
    return heights;
}

std::vector<double> boundWishes(std::vector<double> wishesM, const std::vector<HeightStep>& steps,
                                const std::vector<HeightBound>& bounds)
{
    // The greatest heights below the bounds keep every step, and so does the lower of two such heights.
    std::vector<double> most(wishesM.size(), std::numeric_limits<double>::infinity()), least = most;
    bool hasMost = false, hasLeast = false;
    for (const HeightBound& bound : bounds)
    {
        most[bound.node] = std::min(most[bound.node], bound.mostM);
        least[bound.node] = std::min(least[bound.node], -bound.leastM); // upside down
        hasMost = hasMost || std::isfinite(bound.mostM);
        hasLeast = hasLeast || std::isfinite(bound.leastM);
    }
    if (hasMost) most = lowered(std::move(most), steps);
    if (hasLeast) least = lowered(std::move(least), mirroredSteps(steps));
    for (std::size_t i = 0; i < wishesM.size(); ++i)
        wishesM[i] = std::max(std::min(wishesM[i], most[i]), -least[i]);
    return wishesM;
}

} // namespace scenery
