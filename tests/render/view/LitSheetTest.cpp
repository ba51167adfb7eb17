// SPDX-License-Identifier: Apache-2.0
// A sheet with a lamp behind it, as the face of a runway's sign: bright by night, as any other by day.
#include <gtest/gtest.h>

#include "RenderedView.h"

namespace
{

/// The green of a sheet with a lamp behind it, and of one without, 10 m before the eye. `sunDeg`: above the
/// horizon behind the eye.
struct Sheets
{
    explicit Sheets(double sunDeg)
    {
        osgSky::AtmosphereSettings air;
        air.sunDirectionWorld = osgSky::sunDirectionFromAngles(270.0, sunDeg);
        const rendered::ViewScene scene(air);
        scene.root->addChild(
            measurement::greyBox({0.0F, 0.2F, 0.5F}, {1.0F, 2.0F, 2.5F}, 0.7F, scenery::Finish::lit));
        scene.root->addChild(measurement::greyBox({0.0F, -2.0F, 0.5F}, {1.0F, -0.2F, 2.5F}, 0.7F));
        const auto picture = rendered::pictureFrom(
            scene.root, scenery::poseLookingAt({-10.0, 0.0, 1.5}, {0.0, 0.0, 1.5}), rendered::smallPicture());
        lit = picture->data(64, 60)[1];
        matt = picture->data(96, 60)[1];
    }

    int lit = 0, matt = 0;
};

TEST(LitSheet, IsBrightByNightAndAsAnyOtherByDay)
{
    const Sheets night(-20.0), day(30.0);
    EXPECT_GT(night.lit, 80);
    EXPECT_LT(night.matt, 40);
    EXPECT_NEAR(day.lit, day.matt, 2);
    EXPECT_GT(day.matt, 80);
}

} // namespace
