// SPDX-License-Identifier: Apache-2.0
#include "simulation/tour/HeightProfile.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

namespace simulation
{
namespace
{

constexpr double kCorridorShare = 1.0 / 3.0; ///< of the medium height, to each side
constexpr double kBeyondShare = 0.2; ///< of the length, flown on straight: the end must not face a wall
constexpr double kWindowS = 1.0;     ///< ground that far ahead and behind counts too
constexpr double kSmoothS = 1.2;     ///< half-width of each smoothing pass
constexpr int kSmoothPasses = 3;

/// Wanted height above ground along the way, as shares of the whole.
struct Key
{
    double at;
    double TourScale::*height;
};
constexpr std::array<Key, 6> kKeys = {{{0.0, &TourScale::highM},
                                       {0.15, &TourScale::highM},
                                       {0.42, &TourScale::mediumM},
                                       {0.66, &TourScale::lowM},
                                       {0.80, &TourScale::lowM},
                                       {1.0, &TourScale::mediumM}}};

double wantedM(double share, const TourScale& scale)
{
    std::size_t i = 0;
    while (i + 2 < kKeys.size() && share > kKeys[i + 1].at)
        ++i;
    const double eased = glm::smoothstep(kKeys[i].at, kKeys[i + 1].at, share);
    return scale.*kKeys[i].height + eased * (scale.*kKeys[i + 1].height - scale.*kKeys[i].height);
}

/// Highest ground between two places of the plan's corridor, looked at no coarser than the samples lie.
double corridorGroundM(const glm::dvec2& place, double headingRad, double stepM, const TourTerrain& terrain,
                       const TourScale& scale)
{
    const glm::dvec2 left(-std::sin(headingRad), std::cos(headingRad));
    const glm::dvec2 ahead(std::cos(headingRad), std::sin(headingRad));
    const double half = kCorridorShare * scale.mediumM;
    const double spacing = std::max(terrain.sampleSpacingM, half / 24.0);
    const int across = std::max(2, static_cast<int>(std::ceil(half / spacing)));
    const int along = std::max(1, static_cast<int>(std::ceil(stepM / spacing)));
    double highest = -1e300;
    for (int a = 0; a < along; ++a)
        for (int c = -across; c <= across; ++c)
        {
            const glm::dvec2 at = place + ahead * (stepM * a / along) + left * (half * c / across);
            highest = std::max(highest, terrain.heightM(at.x, at.y));
        }
    return highest;
}

std::vector<double> windowMaximum(const std::vector<double>& values, int half)
{
    std::vector<double> maxima(values.size());
    const int count = static_cast<int>(values.size());
    for (int i = 0; i < count; ++i)
        maxima[static_cast<std::size_t>(i)] = *std::max_element(
            values.begin() + std::max(0, i - half), values.begin() + std::min(count, i + half + 1));
    return maxima;
}

/// Raises what is too low to be reached or left within the slopes.
void limitSlope(std::vector<double>& heights, double riseM, double sinkM)
{
    for (std::size_t i = 1; i < heights.size(); ++i)
        heights[i] = std::max(heights[i], heights[i - 1] - sinkM);
    for (std::size_t i = heights.size() - 1; i-- > 0;)
        heights[i] = std::max(heights[i], heights[i + 1] - riseM);
}

/// A moving mean; keeps every bound on the slope. Beyond the ends the curve goes on as it ended.
std::vector<double> movingMean(const std::vector<double>& values, int half)
{
    const int last = static_cast<int>(values.size()) - 1;
    const auto at = [&](int i)
    {
        if (i < 0) return 2.0 * values.front() - values[static_cast<std::size_t>(std::min(last, -i))];
        if (i > last)
            return 2.0 * values.back() - values[static_cast<std::size_t>(std::max(0, 2 * last - i))];
        return values[static_cast<std::size_t>(i)];
    };
    std::vector<double> means(values.size());
    for (int i = 0; i <= last; ++i)
    {
        double sum = 0.0;
        for (int k = -half; k <= half; ++k)
            sum += at(i + k);
        means[static_cast<std::size_t>(i)] = sum / (2 * half + 1);
    }
    return means;
}

} // namespace

double HeightProfile::smallestClearanceM() const
{
    double smallest = 1e300;
    for (std::size_t i = 0; i < heightM.size(); ++i)
        smallest = std::min(smallest, heightM[i] - groundM[i]);
    return smallest;
}

double HeightProfile::largestClimb() const
{
    double largest = 0.0;
    for (std::size_t i = 1; i < heightM.size(); ++i)
        largest = std::max(largest, (heightM[i] - heightM[i - 1]) / stepM);
    return largest;
}

double HeightProfile::largestSink() const
{
    double largest = 0.0;
    for (std::size_t i = 1; i < heightM.size(); ++i)
        largest = std::max(largest, (heightM[i - 1] - heightM[i]) / stepM);
    return largest;
}

bool HeightProfile::isWithin(const TourScale& scale) const
{
    return smallestClearanceM() >= scale.clearanceM - 1e-6 && largestClimb() <= scale.climbSlope + 1e-9 &&
           largestSink() <= scale.sinkSlope + 1e-9;
}

HeightProfile heightProfile(const FlightPlan& plan, const TourTerrain& terrain, const TourScale& scale)
{
    const std::size_t count = plan.places.size();
    HeightProfile profile;
    profile.stepM = scale.lengthM / static_cast<double>(count - 1);
    const auto beyond = static_cast<std::size_t>(kBeyondShare * static_cast<double>(count));
    const glm::dvec2 onward(std::cos(plan.headingsRad.back()), std::sin(plan.headingsRad.back()));
    std::vector<double> ground;
    for (std::size_t i = 0; i < count + beyond; ++i)
    {
        const glm::dvec2 place =
            i < count ? plan.places[i]
                      : plan.places.back() + onward * (profile.stepM * static_cast<double>(i - count + 1));
        const double heading = plan.headingsRad[std::min(i, count - 1)];
        ground.push_back(corridorGroundM(place, heading, profile.stepM, terrain, scale));
    }
    const auto samples = [&](double seconds)
    { return std::max(1, static_cast<int>(seconds * scale.speedMps / profile.stepM)); };
    std::vector<double> heights = windowMaximum(ground, samples(kWindowS));
    for (std::size_t i = 0; i < heights.size(); ++i)
        heights[i] += wantedM(std::min(1.0, static_cast<double>(i) / static_cast<double>(count - 1)), scale);
    limitSlope(heights, scale.climbSlope * profile.stepM, scale.sinkSlope * profile.stepM);
    for (int pass = 0; pass < kSmoothPasses; ++pass)
        heights = movingMean(heights, samples(kSmoothS));
    profile.groundM.assign(ground.begin(), ground.begin() + static_cast<std::ptrdiff_t>(count));
    profile.heightM.assign(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(count));
    const double missing = scale.clearanceM - profile.smallestClearanceM();
    if (missing > 0.0)
        for (double& height : profile.heightM)
            height += missing;
    for (std::size_t i = 0; i < count; ++i)
    {
        const double wanted = wantedM(static_cast<double>(i) / static_cast<double>(count - 1), scale);
        profile.excess += std::fabs(profile.heightM[i] - profile.groundM[i] - wanted) / scale.mediumM;
    }
    profile.excess /= static_cast<double>(count);
    return profile;
}

} // namespace simulation
