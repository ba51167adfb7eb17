// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/LightPoint.h"

#include <cmath>
#include <functional>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "measurement/light/LampFigures.h"
#include "scenery/lights/Allard.h"
#include "scenery/lights/LightSteps.h"

using scenery::LightGroup;
using scenery::LightPoint;

namespace
{

using measurement::worstRange;

double towards(const LightPoint& lamp, double asideDeg, double upDeg)
{
    const double a = glm::radians(asideDeg), u = glm::radians(upDeg);
    return candelaTowards(
        lamp, 100.0 * glm::dvec3(std::cos(u) * std::cos(a), std::cos(u) * std::sin(a), std::sin(u)), 0.0);
}

/// How far the sectors of an aircraft's lamps are from 14 CFR 23.1391, as a share.
double worstSector(const LightPoint& left)
{
    struct Sector
    {
        double fromDeg, toDeg, candela;
    };
    double worst = 0.0;
    for (const Sector& sector : {Sector{0, 10, 40}, {10, 20, 30}, {20, 110, 5}})
        for (double deg = sector.fromDeg + 0.5; deg < sector.toDeg; deg += 0.5)
            worst = std::max(worst, std::abs(towards(left, deg, 0.0) / sector.candela - 1.0));
    return worst;
}

} // namespace

TEST(Allard, LampsAreSeenAsFarAsTheTableSays)
{
    EXPECT_LT(worstRange(scenery::visibleRangeM), 0.03);
    // Without the air, and with the contrast of 37 % that others take for the visibility.
    EXPECT_GT(worstRange([](double candela, double, double leastLx) { return std::sqrt(candela / leastLx); }),
              1.0);
    EXPECT_GT(worstRange([](double candela, double visibilityM, double leastLx)
                         { return scenery::visibleRangeM(candela, 3.0 * visibilityM, leastLx); }),
              0.5);
}

TEST(Allard, TheEyesThresholdRisesWithTheBackgroundWithoutAJump)
{
    EXPECT_DOUBLE_EQ(scenery::leastIlluminanceLx(0.001), 8e-7);
    EXPECT_DOUBLE_EQ(scenery::leastIlluminanceLx(6.8), 8e-7) << "2 fL";
    EXPECT_NEAR(scenery::leastIlluminanceLx(std::sqrt(50.0 * 999.0)), 1e-5, 1e-7);
    EXPECT_NEAR(scenery::leastIlluminanceLx(std::sqrt(1000.0 * 12000.0)), 1e-4, 1e-6);
    EXPECT_NEAR(scenery::leastIlluminanceLx(40000.0), 1e-3, 1e-6);
    const auto greatestStep = [](const std::function<double(double)>& least)
    {
        double step = 0.0;
        for (double log = -3.0; log < 5.0; log += 0.01)
        {
            const double ratio = least(std::pow(10.0, log + 0.01)) / least(std::pow(10.0, log));
            EXPECT_GE(ratio, 1.0);
            step = std::max(step, ratio);
        }
        return step;
    };
    EXPECT_LT(greatestStep(scenery::leastIlluminanceLx), 1.06);
    EXPECT_GT(greatestStep([](double background)
                           { return background < 50.0     ? 8e-7
                                    : background < 1000.0 ? 1e-5
                                                          : 1e-4; }),
              5.0)
        << "the table of classes as it stands";
}

TEST(Allard, TheBackgroundFollowsTheSun)
{
    double before = 0.0;
    for (double deg = -20.0; deg < 90.0; deg += 0.25)
    {
        const double now = scenery::backgroundCdM2(deg, 0.0);
        EXPECT_GE(now, before);
        EXPECT_GT(now, scenery::backgroundCdM2(deg, 1.0));
        before = now;
    }
    EXPECT_LT(scenery::backgroundCdM2(-6.0, 0.0), 6.85)
        << "at the end of civil twilight it is night to the eye";
    EXPECT_GT(scenery::backgroundCdM2(45.0, 0.0), 12000.0) << "a bright day";
}

TEST(Beam, SectorsOfAnAircraftAreThoseOfTheRule)
{
    const auto [left, right, rear] = measurement::defaultPositionLamps();
    EXPECT_LT(worstSector(left), 0.05);
    EXPECT_GT(worstSector(right), 0.5) << "the other side's lamp";
    for (double deg = -179.0; deg < 180.0; deg += 1.0)
        EXPECT_NEAR(towards(left, deg, 3.0), towards(right, -deg, 3.0), 1e-9);
    for (double deg = 111.0; deg < 249.0; deg += 1.0)
        EXPECT_NEAR(towards(rear, deg, 0.0), 20.0, 1.0);
    struct Band
    {
        double deg, share;
    };
    for (const Band& band : {Band{2, .9}, {7, .8}, {12, .7}, {17, .5}, {25, .3}, {35, .1}, {60, .05}})
        for (const double side : {-1.0, 1.0})
            EXPECT_NEAR(towards(left, 5.0, side * band.deg) / 40.0, band.share, 0.05 * band.share)
                << band.deg;
}

TEST(Beam, OverlapsStayBelowTheirLimits)
{
    const auto [left, right, rear] = measurement::defaultPositionLamps();
    const auto isWithin = [](const LightPoint& lamp, double firstDeg, double lastDeg)
    {
        bool good = true;
        for (double beyond = 0.5; beyond < 60.0; beyond += 0.5)
        {
            const double most = beyond < 10.0 ? 10.0 : beyond < 20.0 ? 10.0 : 1.0;
            good = good && towards(lamp, firstDeg - beyond, 0.0) <= most &&
                   towards(lamp, lastDeg + beyond, 0.0) <= most;
        }
        return good;
    };
    EXPECT_TRUE(isWithin(left, 0.0, 110.0));
    EXPECT_TRUE(isWithin(rear, 110.0, 250.0));
    LightPoint turned = left;
    turned.headingDeg = -15.0;
    EXPECT_FALSE(isWithin(turned, 0.0, 110.0));
}

TEST(LightSteps, EachIsBrighterThanTheLast)
{
    for (int i = 1; i < scenery::kLightGroups; ++i)
    {
        const auto group = static_cast<LightGroup>(i);
        EXPECT_EQ(scenery::shareOfStep(group, 0), 0.0);
        for (int step = 1; step <= 5; ++step)
            EXPECT_GT(scenery::shareOfStep(group, step), scenery::shareOfStep(group, step - 1));
        EXPECT_EQ(scenery::shareOfStep(group, 5), 1.0);
    }
    EXPECT_EQ(scenery::shareOfStep(LightGroup::runway, 4), 0.25);
    EXPECT_EQ(scenery::shareOfStep(LightGroup::runway, 3), 0.05);
    EXPECT_EQ(scenery::shareOfStep(LightGroup::approach, 2), 0.01);
    EXPECT_EQ(scenery::shareOfStep(LightGroup::approach, 1), 0.002);
    EXPECT_EQ(scenery::shareOfStep(LightGroup::papi, 4), 0.3);
    EXPECT_EQ(scenery::shareOfStep(LightGroup::papi, 3), 0.1);
}

TEST(LightSteps, ByDayInGoodAirAllButPapiAreOff)
{
    const auto day = scenery::levelsOf({}, 40.0, 60000.0), fog = scenery::levelsOf({}, 40.0, 1500.0),
               night = scenery::levelsOf({}, -20.0, 60000.0);
    for (int i = 1; i < scenery::kLightGroups; ++i)
    {
        const auto at = static_cast<std::size_t>(i);
        EXPECT_EQ(day[at] > 0.0F, static_cast<LightGroup>(i) == LightGroup::papi) << i;
        EXPECT_GT(night[at], 0.0F) << i;
    }
    EXPECT_EQ(fog[static_cast<std::size_t>(LightGroup::approach)], 1.0F);
}

TEST(LightSteps, AnInstructorSetsThemByName)
{
    const auto steps = scenery::lightStepsOf("all=0,approach=5,papi=3");
    ASSERT_TRUE(steps);
    const auto levels = scenery::levelsOf(*steps, -20.0, 60000.0);
    EXPECT_EQ(levels[static_cast<std::size_t>(LightGroup::steady)], 1.0F);
    EXPECT_EQ(levels[static_cast<std::size_t>(LightGroup::approach)], 1.0F);
    EXPECT_EQ(levels[static_cast<std::size_t>(LightGroup::papi)], 0.1F);
    EXPECT_EQ(levels[static_cast<std::size_t>(LightGroup::street)], 0.0F);
    for (const char* wrong :
         {"approach", "approach=6", "approach=55", "aproach=3", "steady=3", "=3", "papi=-1"})
        EXPECT_FALSE(scenery::lightStepsOf(wrong)) << wrong;
}

TEST(LightPoint, FlashesAsLongAsItSays)
{
    const scenery::Flash flash{1.2, 0.3, 0.1};
    int lit = 0;
    for (int i = 0; i < 12000; ++i)
        lit += scenery::isLit(flash, 0.001 * i) ? 1 : 0;
    EXPECT_NEAR(lit, 1000, 3);
    EXPECT_TRUE(scenery::isLit(flash, 0.35));
    EXPECT_FALSE(scenery::isLit(flash, 0.45));
    EXPECT_TRUE(scenery::isLit({}, 7.0));
}
