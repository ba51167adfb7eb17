// SPDX-License-Identifier: Apache-2.0
#include "scenery/lights/RunwayLights.h"

#include <algorithm>
#include <cmath>

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include "scenery/lights/PapiUnits.h"

using scenery::LightGroup;
using scenery::LightPoint;
using scenery::RunwayClass;
using scenery::RunwayPlan;

namespace
{

const foundation::HeightInPlan kLevel = [](const glm::dvec2&) { return std::optional(100.0); };

RunwayPlan runway(double lengthM, double widthM = 45.0, bool isPaved = true)
{
    return {{0.0, 0.0}, {lengthM, 0.0}, widthM, isPaved};
}

std::size_t countOf(const std::vector<LightPoint>& lights, LightGroup group)
{
    return static_cast<std::size_t>(std::count_if(
        lights.begin(), lights.end(), [&](const LightPoint& light) { return light.group == group; }));
}

/// The candela of a group towards an eye.
double towards(const std::vector<LightPoint>& lights, LightGroup group, const glm::dvec3& eye)
{
    double sum = 0.0;
    for (const LightPoint& light : lights)
        if (light.group == group) sum += candelaTowards(light, eye, 0.0);
    return sum;
}

} // namespace

TEST(RunwayLights, AreThoseOfItsClass)
{
    EXPECT_EQ(classOf(runway(1500.0, 30.0, false)), RunwayClass::unlit);
    EXPECT_TRUE(runwayLights(runway(1500.0, 30.0, false), kLevel).empty());
    EXPECT_EQ(classOf(runway(900.0)), RunwayClass::visual);
    EXPECT_EQ(classOf(runway(1500.0)), RunwayClass::nonPrecision);
    EXPECT_EQ(classOf(runway(3000.0, 30.0)), RunwayClass::precision);
    EXPECT_EQ(classOf(runway(3000.0)), RunwayClass::precisionTwo);
    const auto visual = runwayLights(runway(900.0), kLevel), simple = runwayLights(runway(1500.0), kLevel),
               precise = runwayLights(runway(3000.0, 30.0), kLevel),
               two = runwayLights(runway(3000.0), kLevel);
    EXPECT_EQ(countOf(visual, LightGroup::approach), 0u);
    EXPECT_EQ(countOf(simple, LightGroup::approach), 2u * (7 * 3 + 11));
    EXPECT_EQ(countOf(precise, LightGroup::approach), 2u * (30 * 5 + 13 + 20));
    EXPECT_EQ(countOf(precise, LightGroup::centreLine), 0u);
    EXPECT_EQ(countOf(two, LightGroup::centreLine), 2u * 199);
    EXPECT_EQ(countOf(two, LightGroup::touchdownZone), 2u * 15 * 6);
}

TEST(RunwayLights, EdgesStandBesideTheRunwayAtMost60MetresApart)
{
    std::vector<double> along;
    for (const LightPoint& light : runwayLights(runway(1500.0), kLevel))
        if (light.group == LightGroup::runway && light.beam == scenery::BeamKind::runwayEdge)
        {
            EXPECT_NEAR(std::abs(light.place.y), 24.0, 1e-9);
            EXPECT_NEAR(light.place.z, 100.35, 1e-9);
            along.push_back(light.place.x);
        }
    std::sort(along.begin(), along.end());
    for (std::size_t i = 0; i + 1 < along.size(); ++i)
        EXPECT_LE(along[i + 1] - along[i], 60.0);
    EXPECT_EQ(along.front(), 0.0);
    EXPECT_EQ(along.back(), 1500.0);
}

TEST(RunwayLights, ShowTheirColoursToThoseWhoLandAndToThoseWhoRollOut)
{
    const auto lights = runwayLights(runway(1800.0), kLevel);
    const glm::dvec3 landing(-3000.0, 0.0, 260.0), rolling(900.0, 0.0, 103.0);
    bool hasGreen = false, hasRed = false, hasYellow = false, hasWhite = false;
    for (const LightPoint& light : lights)
    {
        if (light.group != LightGroup::runway) continue;
        const bool isRed = light.colour.g < 0.3F, isGreen = light.colour.r < 0.3F,
                   isYellow = light.colour.b < 0.5F && !isRed && !isGreen;
        if (candelaTowards(light, landing, 0.0) > 1000.0 && light.place.x < 10.0)
            (isGreen ? hasGreen : hasWhite) = true;
        EXPECT_FALSE(isGreen && light.place.x > 10.0 && candelaTowards(light, landing, 0.0) > 0.0);
        if (candelaTowards(light, rolling, 0.0) < 50.0 || light.place.x < 1300.0) continue;
        hasRed = hasRed || isRed;
        hasYellow = hasYellow || isYellow;
        EXPECT_FALSE(isGreen) << "the other threshold is seen from outside alone";
    }
    EXPECT_TRUE(hasGreen);
    EXPECT_TRUE(hasWhite);
    EXPECT_TRUE(hasRed);
    EXPECT_TRUE(hasYellow);
}

TEST(RunwayLights, ApproachLightsShineAlongTheGlidePathAndNotBack)
{
    const auto lights = runwayLights(runway(2000.0, 30.0), kLevel);
    const auto out = [](double distanceM) { return glm::dvec3(-distanceM, 0.0, 100.0 + 0.0524 * distanceM); };
    EXPECT_GT(towards(lights, LightGroup::approach, out(8000.0)), 100.0 * 20000.0 * 0.5);
    EXPECT_LT(towards(lights, LightGroup::approach, {1000.0, 5000.0, 500.0}), 100.0);
    for (const LightPoint& light : lights)
        EXPECT_TRUE(light.place.x >= -900.0 && light.place.x <= 2900.0);
}

TEST(RunwayLights, ApproachLightsDoNotFollowTheGroundIntoAPit)
{
    const foundation::HeightInPlan pit = [](const glm::dvec2& place)
    { return std::optional(place.x < -100.0 ? 50.0 : 100.0); };
    for (const LightPoint& light : runwayLights(runway(2000.0, 30.0), pit))
    {
        EXPECT_GT(light.place.z, 100.0 + std::min(light.place.x, 0.0) / 66.0);
    }
}

TEST(RunwayLights, FlashersRunTowardsTheThresholdTwiceASecond)
{
    double before = 1e9;
    for (double timeS = 0.05; timeS < 0.49; timeS += 0.025)
        for (const LightPoint& light : runwayLights(runway(2000.0, 30.0), kLevel))
        {
            if (light.flash.periodS <= 0.0 || light.place.x > 0.0 || !isLit(light.flash, timeS)) continue;
            EXPECT_LE(-light.place.x, before + 61.0);
            before = -light.place.x;
        }
    EXPECT_LT(before, 400.0);
}

TEST(TaxiwayLights, AreBlueAndStandOnNoRunway)
{
    const std::vector<glm::dvec2> middle{{750.0, -10.0}, {750.0, 170.0}, {750.0, 200.0}, {1000.0, 200.0}};
    const std::vector<RunwayPlan> runways{runway(1500.0)};
    const auto lights = scenery::taxiwayLights(middle, 15.0, runways, kLevel);
    EXPECT_GT(lights.size(), 12u);
    for (const LightPoint& light : lights)
    {
        EXPECT_GT(light.colour.b, 2.0F * light.colour.r);
        EXPECT_GT(light.place.y, 23.0);
    }
    EXPECT_GT(scenery::taxiwayLights(middle, 15.0, {}, kLevel).size(), lights.size());
}

TEST(PapiLamp, IsRedBelowItsAngleAndWhiteAboveIt)
{
    const auto units = scenery::papiUnits({0.0, 0.0}, {1.0, 0.0}, 1500.0, 30.0);
    for (const auto& unit : units)
    {
        const LightPoint lamp = lampOf(unit);
        const auto greenAt = [&](double minutes)
        {
            const double up = std::tan(glm::radians(unit.angleDeg + minutes / 60.0));
            return colourTowards(lamp, lamp.place + 5000.0 * glm::dvec3(-1.0, 0.0, up)).g;
        };
        EXPECT_LT(greenAt(-1.5), 0.05F);
        EXPECT_GT(greenAt(1.5), 0.93F);
        EXPECT_GT(candelaTowards(lamp, lamp.place + glm::dvec3(-5000.0, 0.0, 262.0), 0.0), 12000.0);
        EXPECT_EQ(candelaTowards(lamp, lamp.place + glm::dvec3(5000.0, 0.0, 262.0), 0.0), 0.0);
    }
}
