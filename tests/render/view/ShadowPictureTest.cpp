// SPDX-License-Identifier: Apache-2.0
// The shadow of a car in pictures: it darkens the ground, and does not fight with it for depth.
#include <gtest/gtest.h>

#include "RenderedDefaultCar.h"
#include "RenderedView.h"

namespace
{

constexpr double kSunDeg = 40.0;

/// How many pixels of a picture the shadow darkens, and the sum by which it brightens others (it may not).
/// `groundM`: of the true surface below the drawn one, on which the shadow is laid.
struct Darkened
{
    int pixels = 0, brighter = 0;
};

Darkened darkenedFrom(const glm::dvec3& eye, double groundM)
{
    osgOffscreen::OffscreenSettings settings;
    settings.backend = osgOffscreen::defaultBackend();
    settings.widthPx = 480;
    settings.heightPx = 270;
    settings.samples = 1;
    const auto pictureWith = [&](bool hasShadow)
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(90.0, kSunDeg);
        const rendered::ViewScene scene(air);
        DefaultCar car;
        const double radians = glm::radians(kSunDeg);
        car.car.castShadow({std::cos(radians), 0.0, std::sin(radians)},
                           [&](double, double) { return simulation::GroundSample{groundM}; });
        scene.root->addChild(car.node());
        if (hasShadow) scene.root->addChild(car.car.shadow());
        return rendered::pictureFrom(scene.root, scenery::poseLookingAt(eye, {0.0, 0.0, 0.0}), settings);
    };
    const osg::ref_ptr<osg::Image> with = pictureWith(true), without = pictureWith(false);
    Darkened result;
    for (int y = 0; y < with->t(); ++y)
        for (int x = 0; x < with->s(); ++x)
        {
            const int change = with->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[1] -
                               without->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[1];
            result.pixels += change < -25 ? 1 : 0;
            result.brighter += change > 1 ? 1 : 0;
        }
    return result;
}

} // namespace

TEST(ShadowPicture, LiesOnTheDrawnGroundFromAboveAndFromADriversEye)
{
    for (const glm::dvec3& eye : {glm::dvec3(-3.0, -6.0, 12.0), glm::dvec3(-14.0, -10.0, 1.2)})
    {
        const Darkened exact = darkenedFrom(eye, 0.0), lower = darkenedFrom(eye, -0.01);
        EXPECT_GT(exact.pixels, 100);
        EXPECT_EQ(exact.brighter, 0);
        // Drawn and true surface may differ by 1 cm: then the shadow lies a little elsewhere, but has no
        // holes.
        EXPECT_GT(lower.pixels, 0.95 * exact.pixels);
        EXPECT_LT(lower.pixels, 1.2 * exact.pixels);
    }
}

TEST(ShadowPicture, FarBelowTheDrawnGroundItIsHidden)
{
    EXPECT_LT(darkenedFrom({-3.0, -6.0, 12.0}, -0.9).pixels,
              darkenedFrom({-3.0, -6.0, 12.0}, 0.0).pixels / 10)
        << "the mutation";
}
