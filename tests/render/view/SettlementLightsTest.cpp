// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/SettlementLights.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "RenderedPicture.h"
#include "RenderedView.h"
#include "scenery/lights/LightSteps.h"
#include "scenery/lights/LitTimes.h"

using scenery::LightGroup;

namespace
{

const foundation::HeightInPlan kGround = [](const glm::dvec2&) { return std::optional(0.0); };
constexpr double kNight = -20.0, kDay = 40.0;

struct Village
{
    std::vector<scenery::StreetLamp> lamps;
    std::vector<scenery::WindowPane> panes;
};

/// A dwelling's room that is lit for a while in the evening, and when in its middle.
std::pair<std::uint64_t, double> roomLitInTheEvening()
{
    for (std::uint64_t room = 1;; ++room)
        if (const scenery::Flash lit = litTimes(scenery::RoomUse::dwelling, room);
            lit.litS > 3600.0 && lit.litS < 8.0 * 3600.0)
            return {room, lit.startS + 0.5 * lit.litS};
}

/// A picture of it by night or by day.
osg::ref_ptr<osg::Image> pictureOf(const Village& village, const scenery::Pose& eye, double sunDeg,
                                   double dayS = 0.0, const scenery::LightSteps& steps = {})
{
    osgSky::AtmosphereSettings air;
    air.sunDirectionWorld = osgSky::sunDirectionFromAngles(180.0, sunDeg);
    const rendered::ViewScene scene(air);
    scenery::LightUniforms uniforms(*scene.root->getStateSet());
    const auto levels = scenery::levelsOf(steps, sunDeg, air.visibilityM);
    uniforms.show(sunDeg < 0.0 ? 8e-7 : 1e-3, 0.0, dayS, levels);
    scenery::SettlementLights lights(village.lamps, village.panes, {}, kGround);
    lights.light(levels);
    scene.root->addChild(lights.node());
    osgOffscreen::OffscreenSettings settings = rendered::smallPicture();
    settings.backend = osgOffscreen::defaultBackend();
    return rendered::pictureFrom(scene.root, eye, settings);
}

double sumOf(const osg::Image& image)
{
    double sum = 0.0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            sum += image.data(static_cast<unsigned>(x), static_cast<unsigned>(y))[1];
    return sum;
}

bool isSame(const osg::Image& a, const osg::Image& b)
{
    return std::memcmp(a.data(), b.data(), a.getTotalSizeInBytes()) == 0;
}

Village oneLamp()
{
    Village village;
    village.lamps.push_back({{30.0, 0.0}, {-1.0, 0.0}, 6.0, false});
    return village;
}

const scenery::Pose kBesideLamp = scenery::poseLookingAt({0.0, -12.0, 6.0}, {28.0, 0.0, 0.0});

} // namespace

TEST(SettlementLights, AStreetLampLightsTheGroundByNight)
{
    const auto lit = pictureOf(oneLamp(), kBesideLamp, kNight), none = pictureOf({}, kBesideLamp, kNight),
               off = pictureOf(oneLamp(), kBesideLamp, kNight, 0.0, *scenery::lightStepsOf("street=0"));
    const double pixels = 160.0 * 120.0;
    EXPECT_GT((sumOf(*lit) - sumOf(*none)) / pixels, 5.0) << "levels of 255 in the mean";
    EXPECT_LT((sumOf(*off) - sumOf(*none)) / pixels, 0.5) << "but for its post";
}

TEST(SettlementLights, ByDayNothingShines)
{
    Village village = oneLamp();
    const auto [room, litS] = roomLitInTheEvening();
    village.panes.push_back({{20.0, 2.0, 1.0}, {20.0, 0.8, 1.0}, 1.3, scenery::RoomUse::dwelling, room});
    Village posts = oneLamp();
    EXPECT_TRUE(
        isSame(*pictureOf(village, kBesideLamp, kDay, litS), *pictureOf(posts, kBesideLamp, kDay, litS)));
    EXPECT_FALSE(
        isSame(*pictureOf(village, kBesideLamp, kNight, litS), *pictureOf(posts, kBesideLamp, kNight, litS)));
}

TEST(SettlementLights, AWindowIsLitWhileItsRoomIs)
{
    Village village;
    const auto [room, litS] = roomLitInTheEvening();
    village.panes.push_back({{20.0, 2.0, 1.0}, {20.0, 0.8, 1.0}, 1.3, scenery::RoomUse::dwelling, room});
    const auto eye = scenery::poseLookingAt({0.0, 0.0, 1.7}, {20.0, 1.4, 1.7});
    const auto none = pictureOf({}, eye, kNight, litS), lit = pictureOf(village, eye, kNight, litS),
               noon = pictureOf(village, eye, kNight, 12.0 * 3600.0);
    int brighter = 0;
    for (int y = 0; y < lit->t(); ++y)
        for (int x = 0; x < lit->s(); ++x)
            brighter += lit->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[1] >
                        none->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[1] + 40;
    EXPECT_GT(brighter, 25) << "of some hundred pixels";
    EXPECT_TRUE(isSame(*noon, *none));
}

TEST(SettlementLights, AVillageIsSeenFromTenKilometres)
{
    Village village;
    for (int i = 0; i < 12; ++i)
        village.lamps.push_back({{10000.0, 400.0 * (i - 6)}, {0.0, 1.0}, 6.0, i % 2 == 0});
    const auto eye = scenery::poseLookingAt({0.0, 0.0, 1000.0}, {10000.0, 0.0, 0.0});
    const auto lit = pictureOf(village, eye, kNight), none = pictureOf({}, eye, kNight);
    int brighter = 0;
    for (int y = 0; y < lit->t(); ++y)
        for (int x = 0; x < lit->s(); ++x)
            brighter += lit->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[0] >
                        none->data(static_cast<unsigned>(x), static_cast<unsigned>(y))[0] + 3;
    EXPECT_GE(brighter, 8) << "of twelve lamps";
    EXPECT_TRUE(isSame(*pictureOf(village, eye, kNight), *lit)) << "the same bytes again";
}
