// SPDX-License-Identifier: Apache-2.0
// Water and snow on the ground: what is told, what falls, what dries and melts.
#include "simulation/environment/SurfaceWeather.h"

#include <gtest/gtest.h>

#include "simulation/state/EnvironmentState.h"
#include "simulation/vehicle/WeatheredGround.h"

namespace simulation
{
namespace
{

constexpr double kHourS = 3600.0;

Environment falling(const char* type, double mmPerHour)
{
    Environment environment;
    environment.weather.emplace();
    environment.weather->precipitation = Precipitation{type, mmPerHour};
    return environment;
}

TEST(SurfaceWeather, ReadsWhatLiesOnTheGround)
{
    const auto both = readSurfaceWeather("snow 5.5 cleared; moist", "here");
    ASSERT_TRUE(both);
    EXPECT_EQ(*both, (SurfaceWeather{0.1, 5.5, false, true}));
    EXPECT_EQ(readSurfaceWeather("dry", "here")->waterMm, 0.0);
    EXPECT_EQ(*readSurfaceWeather("ice", "here"), (SurfaceWeather{0.5, 0.0, true}));
    EXPECT_EQ(*readSurfaceWeather("water 0.3; ice", "here"), (SurfaceWeather{0.3, 0.0, true}));
    for (const SurfaceWeather& ground : {SurfaceWeather{0.1 + 0.2, 1.0 / 3.0, true, true}, SurfaceWeather{}})
        EXPECT_EQ(*readSurfaceWeather(textOf(ground), "here"), ground);
}

TEST(SurfaceWeather, RefusesWhatIsNothingOnTheGround)
{
    for (const char* text :
         {"", ";", "mud", "snow", "snow -1", "snow nan", "snow 5cm", "water 1e9", "wet;;ice"})
    {
        const auto read = readSurfaceWeather(text, "--ground");
        ASSERT_FALSE(read) << text;
        EXPECT_EQ(read.error().place, "--ground");
        EXPECT_FALSE(read.error().remedy.empty());
    }
}

TEST(SurfaceWeather, RainOfTenMillimetresByHand)
{
    // 10 mm/h fill the texture in three minutes; then the film tends to 10 · 70 s above it.
    EXPECT_NEAR(weathered({}, {.rainMmPerHour = 10.0}, 180.0).waterMm, 0.5, 1e-12);
    EXPECT_NEAR(weathered({}, {.rainMmPerHour = 10.0}, kHourS).waterMm, 0.5 + 10.0 * 70.0 / kHourS, 1e-9);
    // The texture's half a millimetre dries in two hours.
    EXPECT_NEAR(weathered({0.5}, {}, kHourS).waterMm, 0.25, 1e-12);
    EXPECT_EQ(weathered({0.5}, {}, 2.1 * kHourS).waterMm, 0.0);
    // Puddles drain to the texture within some minutes.
    EXPECT_LT(weathered({2.0}, {}, 420.0).waterMm, 0.51);
}

TEST(SurfaceWeather, SnowByHand)
{
    EXPECT_NEAR(weathered({}, {.snowMmPerHour = 2.0}, kHourS).snowCm, 2.0, 1e-12);
    const Fall thaw{.temperatureC = 4.0, .isMelting = true};
    const SurfaceWeather after = weathered({0.0, 3.0}, thaw, kHourS);
    EXPECT_NEAR(after.snowCm, 3.0 - 4.5 / 24.0 * 4.0, 1e-12);
    EXPECT_GT(after.waterMm, 0.4) << "what has melted wets the ground";
    EXPECT_EQ(weathered({0.0, 3.0}, {.temperatureC = -4.0, .isMelting = true}, kHourS).snowCm, 3.0);
    EXPECT_EQ(weathered({0.0, 1.0}, thaw, 1e6).snowCm, 0.0);
}

/// Two hundred short falls leave what one long one does, and each leaves more.
TEST(SurfaceWeather, IsTheSameInManyStepsAndSteady)
{
    constexpr int kSteps = 200;
    for (const Fall& fall :
         {Fall{.rainMmPerHour = 0.3}, Fall{.rainMmPerHour = 50.0}, Fall{.snowMmPerHour = 3.0}})
    {
        SurfaceWeather now;
        for (int i = 1; i <= kSteps; ++i)
        {
            const SurfaceWeather next = weathered(now, fall, kHourS / kSteps);
            ASSERT_GE(next.waterMm, now.waterMm);
            ASSERT_GE(next.snowCm, now.snowCm);
            now = next;
        }
        const SurfaceWeather once = weathered({}, fall, kHourS);
        EXPECT_NEAR(now.waterMm, once.waterMm, 1e-9);
        EXPECT_NEAR(now.snowCm, once.snowCm, 1e-9);
    }
    SurfaceWeather drying{3.0};
    for (int i = 0; i < kSteps; ++i)
    {
        const SurfaceWeather next = weathered(drying, {}, 3.0 * kHourS / kSteps);
        ASSERT_LE(next.waterMm, drying.waterMm);
        drying = next;
    }
    EXPECT_EQ(drying.waterMm, 0.0);
}

TEST(SurfaceWeather, MoreRainLeavesMoreAndLooksWetter)
{
    double film = 0.0, wetness = 0.0;
    for (int i = 1; i <= 200; ++i)
    {
        const double next = weathered({}, {.rainMmPerHour = 0.25 * i}, kHourS).waterMm;
        EXPECT_GT(next, film);
        EXPECT_GE(wetnessOf(next), wetness);
        film = next;
        wetness = wetnessOf(next);
    }
    EXPECT_NEAR(film, 0.5 + 50.0 * 70.0 / kHourS, 1e-6);
    EXPECT_EQ(wetnessOf(0.1), 0.5);
    EXPECT_EQ(wetnessOf(5.0), 1.0);
}

TEST(GroundOfTheClock, WhatFallsAtTheBeginHasFallenForAnHour)
{
    EnvironmentClock clock(std::nullopt);
    clock.apply(falling("snow", 3.0), 0.0);
    EXPECT_NEAR(clock.at(0.0).surface.snowCm, 3.0, 1e-9);
    EXPECT_NEAR(clock.at(kHourS).surface.snowCm, 6.0, 1e-9);
    clock.apply(falling("rain", 5.0), 0.0); // a later word of the begin takes its place
    EXPECT_EQ(clock.at(0.0).surface.snowCm, 0.0);
    EXPECT_GT(clock.at(0.0).surface.waterMm, 0.5);
}

TEST(GroundOfTheClock, WhatFallsLaterBeginsWithNothing)
{
    EnvironmentClock clock(std::nullopt);
    clock.apply({}, 0.0);
    clock.apply(falling("snow", 3.0), 100.0);
    EXPECT_EQ(clock.at(100.0).surface.snowCm, 0.0);
    EXPECT_NEAR(clock.at(100.0 + 0.5 * kHourS).surface.snowCm, 1.5, 1e-9);
    clock.apply(falling("dry", 0.0), 100.0 + 0.5 * kHourS);
    EXPECT_NEAR(clock.at(100.0 + kHourS).surface.snowCm, 1.5, 1e-9) << "it stays when no more falls";
}

TEST(GroundOfTheClock, TheScenarioGoesBeforeTheWorld)
{
    const WorldAir world{.sun = {}, .visibilityM = {}, .ground = SurfaceWeather{0.0, 7.0}};
    EnvironmentClock clock(std::nullopt, world);
    EXPECT_EQ(clock.at(0.0).surface.snowCm, 7.0);
    clock.apply(falling("snow", 3.0), 0.0);
    EXPECT_EQ(clock.at(0.0).surface.snowCm, 7.0) << "what is told is told";
    Environment told;
    told.ground = SurfaceWeather{0.0, 2.0};
    clock.apply(told, 0.0);
    EXPECT_EQ(clock.at(0.0).surface.snowCm, 2.0);
    told.ground = SurfaceWeather{0.0, 9.0};
    clock.apply(told, 5.0);
    EXPECT_EQ(clock.at(5.0).surface.snowCm, 9.0);
}

TEST(GroundOfTheClock, AToldWetnessHoldsAndFrostMakesItIce)
{
    EnvironmentClock clock(std::nullopt);
    Environment moist;
    moist.roadWetness = "moist";
    clock.apply(moist, 0.0);
    EXPECT_EQ(clock.at(5.0 * kHourS).surface.waterMm, 0.1);
    EXPECT_FALSE(clock.at(0.0).surface.isIcy);
    Environment frost;
    frost.weather.emplace();
    frost.weather->temperatureK = 270.0;
    clock.apply(frost, 0.0);
    EXPECT_TRUE(clock.at(0.0).surface.isIcy);
}

/// What a wheel meets on a kind of ground in a weather.
GroundKind metOn(GroundKind kind, const SurfaceWeather& surface)
{
    EnvironmentState environment;
    environment.surface = surface;
    const WeatheredGround ground(std::make_shared<LevelGround>(0.0, kind), groundWeatherOf(environment));
    const glm::dvec3 place(0.0);
    GroundPoint below;
    ground.below({&place, 1}, {&below, 1});
    return below.kind;
}

TEST(GroundUnderWeather, SnowLiesOnEverythingButClearedRoadsAndWater)
{
    const SurfaceWeather snow{0.0, 2.0}, cleared{0.1, 2.0, false, true};
    for (const GroundKind kind : {GroundKind::asphalt, GroundKind::gravel, GroundKind::grass})
        EXPECT_EQ(metOn(kind, snow), GroundKind::snow);
    EXPECT_EQ(metOn(GroundKind::water, snow), GroundKind::water);
    EXPECT_EQ(metOn(GroundKind::asphalt, cleared), GroundKind::wetAsphalt);
    EXPECT_EQ(metOn(GroundKind::grass, cleared), GroundKind::snow);
    EXPECT_EQ(metOn(GroundKind::asphalt, {0.5, 0.0, true}), GroundKind::ice);
    EXPECT_EQ(metOn(GroundKind::grass, {0.5, 0.0, true}), GroundKind::grass);
    EXPECT_EQ(metOn(GroundKind::asphalt, {0.01, 0.1}), GroundKind::asphalt) << "a trace changes nothing";
}

} // namespace
} // namespace simulation
