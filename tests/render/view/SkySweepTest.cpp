// SPDX-License-Identifier: Apache-2.0
// Sweeps of the sky over the height of the sun, the visibility and the clouds' cover, 200 steps each: no step
// of a picture's mean luminance is above 2 % of white, what must grow grows, and nothing is black. A sweep
// with a jump in it is found by the same look at it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "measurement/light/view/SkyPictures.h"

using osgSky::AtmosphereSettings;

namespace
{

using measurement::deepestFall;
using measurement::largestStep;
using measurement::SkyPictures;
using measurement::sunAtShare;

constexpr double kMostStep = 0.02;     ///< of white
constexpr double kMostSunStep = 0.012; ///< half a degree of the sun
constexpr double kNoFall = 0.02;       ///< of the light before: rounding of pixels

measurement::SkySweep sweep(const std::function<AtmosphereSettings(double)>& settingsAt,
                            const glm::dvec3& towards)
{
    const auto pictures = SkyPictures::create();
    if (!pictures) throw std::runtime_error(pictures.error().message());
    return (*pictures)->sweep(settingsAt, towards);
}

double shareOf(double elevationDeg)
{
    return measurement::shareOfSun(elevationDeg);
}

} // namespace

TEST(SkySweep, TheSunsHeightChangesTheSkyWithoutAStep)
{
    for (const glm::dvec3& towards : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.6)})
    {
        const auto [levels, lights] = sweep(sunAtShare, towards);
        ASSERT_EQ(levels.size(), static_cast<std::size_t>(SkyPictures::kSteps + 1));
        EXPECT_LE(largestStep(levels), kMostSunStep);
        EXPECT_LE(deepestFall(lights, 0.0, shareOf(35.0)), kNoFall);
        EXPECT_GT(*std::min_element(levels.begin(), levels.end()), 0.01) << "night is not black";
        EXPECT_GT(levels.back(), 5.0 * levels.front());
    }
}

TEST(SkySweep, VisibilityAndCoverChangeTheSkyWithoutAStep)
{
    const auto visibilityAt = [](double share)
    {
        AtmosphereSettings air;
        air.visibilityM = 100.0 * std::pow(600.0, share); // to 60 km
        return air;
    };
    const auto coverAt = [](double share)
    {
        AtmosphereSettings air;
        air.cloudCover = share;
        return air;
    };
    const glm::dvec3 north(0.0, 1.0, 0.0);
    EXPECT_LE(largestStep(sweep(visibilityAt, north).levels), kMostStep);
    EXPECT_LE(largestStep(sweep(coverAt, north).levels), kMostStep);
}

TEST(SkySweep, AJumpAndAFallAreFound)
{
    // The mutations: thin clouds that come at once; a sun that goes back for some degrees.
    const auto jumping = [](double share)
    {
        AtmosphereSettings air = sunAtShare(share);
        air.cloudCover = share > 0.5 ? 0.4 : 0.0;
        return air;
    };
    const auto falling = [](double share)
    { return sunAtShare(share > shareOf(2.0) && share < shareOf(10.0) ? share - shareOf(-17.0) : share); };
    const glm::dvec3 north(0.0, 1.0, 0.0);
    EXPECT_GT(largestStep(sweep(jumping, north).levels), kMostSunStep);
    EXPECT_GT(deepestFall(sweep(falling, north).lights, 0.0, shareOf(35.0)), kNoFall);
}
