// SPDX-License-Identifier: Apache-2.0
// Sweeps of the sky over the height of the sun, the visibility and the clouds' cover, 200 steps each: no step
// of a picture's mean luminance is above 2 % of white, what must grow grows, and nothing is black. A sweep
// with a jump in it is found by the same look at it.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include <gtest/gtest.h>

#include "RenderedView.h"

using osgSky::AtmosphereSettings;

namespace
{

constexpr int kSteps = 200;
constexpr double kMostStep = 0.02;    ///< of white
constexpr double kMostSunStep = 0.03; ///< in twilight: half a degree of the sun is 2.8 % there
constexpr double kNoFall = 0.02;      ///< of the light before: rounding of pixels

/// Mean luminance of the upper half of a picture, which is sky, 0 … 1.
double luminanceOf(const osg::Image& picture)
{
    double sum = 0.0;
    for (int y = picture.t() / 2; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x)
        {
            const unsigned char* pixel = picture.data(static_cast<unsigned>(x), static_cast<unsigned>(y));
            sum += 0.2126 * pixel[0] + 0.7152 * pixel[1] + 0.0722 * pixel[2];
        }
    return sum / (255.0 * picture.s() * (picture.t() - picture.t() / 2));
}

/// Undoes displayColour(): the light that a mean level of the picture stands for.
double lightOf(double level, double exposure)
{
    return std::pow(-std::log(1.0 - std::min(level * level, 0.998)), 1.0 / 1.125) / exposure;
}

/// What a view shows at each step of a sweep: its luminance, and the light that this stands for.
struct Sweep
{
    std::vector<double> levels, lights;
};

/// The eye looks along `towards`, the sky above it.
Sweep sweep(const std::function<AtmosphereSettings(double)>& settingsAt, const glm::dvec3& towards)
{
    const rendered::ViewScene scene;
    osgOffscreen::OffscreenSettings settings;
    settings.widthPx = 48;
    settings.heightPx = 36;
    auto viewer = osgOffscreen::OffscreenViewer::create(settings);
    Sweep seen;
    if (!viewer)
    {
        ADD_FAILURE() << viewer.error().message();
        return seen;
    }
    (*viewer)->viewer().setSceneData(scene.root);
    (*viewer)->camera().setProjectionMatrixAsPerspective(60.0, 4.0 / 3.0, 0.5, 2e5);
    const glm::dvec3 eye(0.0, 0.0, 50.0);
    const glm::dmat4 view = scenery::viewFromWorld(scenery::poseLookingAt(eye, eye + towards));
    (*viewer)->camera().setViewMatrix(osg::Matrixd(&view[0][0]));
    for (int i = 0; i <= kSteps; ++i)
    {
        EXPECT_TRUE(scene.atmosphere->setSettings(settingsAt(static_cast<double>(i) / kSteps)));
        seen.levels.push_back(luminanceOf(*(*viewer)->picture()));
        seen.lights.push_back(lightOf(seen.levels.back(), scene.atmosphere->light().exposure));
    }
    return seen;
}

double largestStep(const std::vector<double>& levels)
{
    double largest = 0.0;
    for (std::size_t i = 0; i + 1 < levels.size(); ++i)
        largest = std::max(largest, std::abs(levels[i + 1] - levels[i]));
    return largest;
}

/// The deepest fall below what has been before, as a share of it, between two shares of a sweep.
double deepestFall(const std::vector<double>& levels, double from, double to)
{
    double highest = 0.0, deepest = 0.0;
    for (auto i = static_cast<std::size_t>(from * kSteps); i <= static_cast<std::size_t>(to * kSteps); ++i)
    {
        highest = std::max(highest, levels.at(i));
        deepest = std::max(deepest, 1.0 - levels.at(i) / highest);
    }
    return deepest;
}

constexpr double kLowestDeg = -20.0, kHighestDeg = 90.0;

double shareOf(double elevationDeg)
{
    return (elevationDeg - kLowestDeg) / (kHighestDeg - kLowestDeg);
}

AtmosphereSettings sunAtShare(double share)
{
    AtmosphereSettings air;
    air.sunDirectionWorld =
        osgSky::sunDirectionFromAngles(180.0, kLowestDeg + share * (kHighestDeg - kLowestDeg));
    return air;
}

} // namespace

TEST(SkySweep, TheSunsHeightChangesTheSkyWithoutAStep)
{
    for (const glm::dvec3& towards : {glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.6)})
    {
        const auto [levels, lights] = sweep(sunAtShare, towards);
        ASSERT_EQ(levels.size(), static_cast<std::size_t>(kSteps + 1));
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
