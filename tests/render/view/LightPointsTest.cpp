// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include "measurement/light/view/LampPictures.h"
#include "scenery/lights/Allard.h"

using scenery::BeamKind;
using scenery::LightPoint;

namespace
{

using measurement::brightestLevel;
using measurement::kNightLx;
using measurement::LampPictures;
using measurement::lightIn;

using Sight = measurement::LampSight;

std::unique_ptr<LampPictures> sceneOf(const std::vector<LightPoint>& lights, int samples = 1)
{
    auto made = LampPictures::create(lights, samples);
    if (!made) throw std::runtime_error(made.error().message());
    return std::move(*made);
}

osg::ref_ptr<osg::Image> pictureOf(const std::vector<LightPoint>& lights, const Sight& sight)
{
    return sceneOf(lights)->picture(sight);
}

/// The distance from which a lamp shows in the picture.
double rangeM(double candela, double visibilityM, double leastLx)
{
    LightPoint light;
    light.candela = candela;
    return rangeInPictureM(*sceneOf({light}), visibilityM, leastLx);
}

/// Least and greatest flux over mean, over 64 places within a pixel.
std::array<double, 2> fluxOverPlaces(double candela, int samples,
                                     const std::function<double(const osg::Image&)>& flux)
{
    LightPoint light;
    light.candela = candela;
    return spreadOverPlaces(*sceneOf({light}, samples), flux);
}

} // namespace

TEST(LightPoints, AreFirstSeenWhereAllardsLawSays)
{
    struct Row
    {
        double candela, visibilityKm, leastLx, rangeKm;
    };
    for (const Row& row : {Row{1000, 1.5, 8e-7, 2.61},
                           {1000, 50, 8e-7, 19.6},
                           {10000, 5, 8e-7, 8.57},
                           {10000, 10, 1e-5, 8.65},
                           {20000, 50, 1e-4, 10.4}})
        EXPECT_NEAR(rangeM(row.candela, 1000.0 * row.visibilityKm, row.leastLx), 1000.0 * row.rangeKm,
                    30.0 * row.rangeKm)
            << row.candela << " cd in " << row.visibilityKm << " km";
    EXPECT_GT(std::abs(rangeM(1000.0, 1800.0, 8e-7) - 2610.0), 0.03 * 2610.0) << "air that is too clear";
}

TEST(LightPoints, KeepTheirFluxWhereverTheyFallBetweenPixels)
{
    const auto all = [](const osg::Image& image) { return lightIn(image); };
    for (const int samples : {1, 4})
        for (const double candela : {300.0, 700.0})
        {
            const auto [least, most] = fluxOverPlaces(candela, samples, all);
            const double within = samples == 1 ? 0.02 : 0.03; // edges of points cut samples
            EXPECT_GT(least, 1.0 - within) << candela << " cd, samples " << samples;
            EXPECT_LT(most, 1.0 + within) << candela << " cd, samples " << samples;
        }
    // What a point without a spread would do: its light is that of one pixel.
    const auto [least, most] = fluxOverPlaces(
        300.0, 1, [](const osg::Image& image) { return std::pow(brightestLevel(image) / 255.0, 1.78); });
    EXPECT_GT(most / least, 1.5);
}

TEST(LightPoints, CoverAsMuchOfThePictureWhereAPixelIsDrawnByMore)
{
    LightPoint light;
    light.candela = 300.0;
    const auto scene = sceneOf({light});
    const double one = lightIn(*scene->picture({}));
    scene->spoilBy(
        [](osg::StateSet& state)
        { state.addUniform(new osg::Uniform("drawnPixels", 2.0F), osg::StateAttribute::OVERRIDE); });
    EXPECT_NEAR(lightIn(*scene->picture({})) / one, 4.0, 0.15) << "of four times as many pixels";
}

TEST(LightPoints, TheirFluxFollowsIntensityDistanceAndSteps)
{
    LightPoint light;
    light.candela = 200.0;
    light.group = scenery::LightGroup::approach;
    Sight sight;
    sight.visibilityM = 1e7;
    const double one = lightIn(*pictureOf({light}, sight));
    light.candela = 400.0;
    EXPECT_NEAR(lightIn(*pictureOf({light}, sight)) / one, 2.0, 0.04);
    sight.eye = {-2000.0, 0.0, 0.0};
    EXPECT_NEAR(lightIn(*pictureOf({light}, sight)) / one, 0.5, 0.01);
    sight.eye = {-1000.0, 0.0, 0.0};
    sight.levels[static_cast<std::size_t>(scenery::LightGroup::approach)] = 0.25F;
    EXPECT_NEAR(lightIn(*pictureOf({light}, sight)) / one, 0.5, 0.01);
    sight.levels[static_cast<std::size_t>(scenery::LightGroup::approach)] = 0.0F;
    EXPECT_EQ(brightestLevel(*pictureOf({light}, sight)), 0) << "nothing beside lamps is but black";
}

TEST(LightPoints, ShineIntoTheirBeamAsTheValuesSay)
{
    LightPoint light;
    light.candela = 2000.0;
    for (const BeamKind kind : {BeamKind::forwardLeft, BeamKind::streetLamp, BeamKind::runwayEdge})
        for (const double asideDeg : {-150.0, -30.0, 5.0, 15.0, 60.0, 170.0})
            for (const double upDeg : {-12.0, 2.0, 33.0})
            {
                light.beam = kind;
                light.headingDeg = 20.0;
                Sight sight;
                const double a = glm::radians(asideDeg + 20.0), u = glm::radians(upDeg);
                sight.eye =
                    1000.0 * glm::dvec3(std::cos(u) * std::cos(a), std::cos(u) * std::sin(a), std::sin(u));
                LightPoint plain;
                plain.candela = std::max(candelaTowards(light, sight.eye, 0.0), 1e-6);
                EXPECT_NEAR(lightIn(*pictureOf({light}, sight)), lightIn(*pictureOf({plain}, sight)),
                            0.03 * lightIn(*pictureOf({plain}, sight)) + 1e-4)
                    << static_cast<int>(kind) << ' ' << asideDeg << ' ' << upDeg;
            }
}

TEST(LightPoints, ChangeTheirColourWithinThreeMinutesOfArc)
{
    LightPoint unit;
    unit.candela = 15000.0;
    unit.tiltDeg = 3.0;
    unit.headingDeg = 180.0;
    unit.beam = BeamKind::papi;
    unit.below = scenery::ColourBelow{{1.0F, 0.0F, 0.0F}, 3.0};
    const auto changeOf = [&] { return colourChange(*sceneOf({unit}), 3.0); };
    const measurement::ColourChange change = changeOf();
    EXPECT_LT(60.0 * change.widthDeg, 3.0) << "minutes";
    EXPECT_GT(60.0 * change.widthDeg, 1.0);
    EXPECT_NEAR(60.0 * (change.middleDeg - 3.0), 0.0, 0.5) << "minutes";
    unit.below->angleDeg = 3.02;
    EXPECT_GT(60.0 * (changeOf().middleDeg - 3.0), 0.5) << "a unit that is set wrong";
}

TEST(LightPoints, FlashByTheTimeThatIsShown)
{
    LightPoint light;
    light.candela = 400.0;
    light.flash = {1.0, 0.25, 0.1};
    for (const double timeS : {0.0, 0.3, 0.5, 1.3, 100.3, 100.4})
    {
        Sight sight;
        sight.timeS = timeS;
        EXPECT_EQ(brightestLevel(*pictureOf({light}, sight)) > 0, isLit(light.flash, timeS)) << timeS;
    }
}
