// SPDX-License-Identifier: Apache-2.0
// The condition of the road under tyres: braking distances by friction and wetness, with recorded inputs.
#include <filesystem>
#include <fstream>

#include "ControlPlay.h"
#include "simulation/vehicle/WeatheredGround.h"

namespace
{

using namespace controlplay;

std::string road(const std::string& attributes, const std::string& weather = "")
{
    return "<GlobalAction><EnvironmentAction><Environment name=\"e\">" + weather + "<RoadCondition " +
           attributes + "/></Environment></EnvironmentAction></GlobalAction>";
}

/// How far a car goes from 20 m/s to a stand with its brake pressed down from the begin.
double brakingWayM(const std::string& globals)
{
    const auto folder = std::filesystem::path(testing::TempDir());
    const std::filesystem::path file = folder / "brake-in-scenario.txt";
    std::ofstream(file) << "osgtrainer-inputs 1\ncolumns time brake throttle\n0 1 0\n";
    simulation::ScenarioText text = driven(20.0, property("inputs", file.string()), "RecordedInputs");
    text.globals = globals;
    const auto player = played(text, 25.0);
    EXPECT_TRUE(player);
    if (!player) return 0.0;
    EXPECT_NEAR(ego(*player).speedMps, 0.0, 0.05);
    return ego(*player).position.x - 100.0;
}

TEST(RoadWeather, FrictionLengthensTheBrakingWayByItsInverse)
{
    const double dry = brakingWayM("");
    // 20² / (2 · 9.81 · 1.0) and some for the brakes to come on.
    EXPECT_GT(dry, 18.0);
    EXPECT_LT(dry, 28.0);
    EXPECT_NEAR(brakingWayM(road("frictionScaleFactor=\"0.5\"")) / dry, 2.0, 0.15);
    EXPECT_NEAR(brakingWayM(road("frictionScaleFactor=\"1\"")) / dry, 1.0, 1e-9);
}

TEST(RoadWeather, WetnessCountsWhereNoFrictionIsGiven)
{
    const double dry = brakingWayM("");
    const double wet = brakingWayM(road(R"(frictionScaleFactor="1" wetness="wetWithPuddles")"));
    EXPECT_NEAR(wet / dry, 1.0 / 0.6, 0.12); // wet asphalt has 0.6 of the grip
    EXPECT_DOUBLE_EQ(brakingWayM(road(R"(frictionScaleFactor="0.5" wetness="moist")")),
                     brakingWayM(road(R"(frictionScaleFactor="0.5")")));
}

TEST(RoadWeather, OfAnEnvironment)
{
    simulation::EnvironmentState environment;
    EXPECT_EQ(simulation::groundWeatherOf(environment), (simulation::GroundWeather{1.0, false}));
    environment.surface.waterMm = 0.5;
    EXPECT_EQ(simulation::groundWeatherOf(environment), (simulation::GroundWeather{1.0, true}));
    environment.surface.isIcy = true;
    EXPECT_EQ(simulation::groundWeatherOf(environment), (simulation::GroundWeather{1.0, false, false, true}));
    environment.surface = {0.1, 3.0};
    EXPECT_EQ(simulation::groundWeatherOf(environment), (simulation::GroundWeather{1.0, true, true}));
    environment.roadFriction = 0.4;
    EXPECT_EQ(simulation::groundWeatherOf(environment), (simulation::GroundWeather{0.4, false}));
}

TEST(RoadWeather, BrakingWaysGrowFromDryOverWetAndSnowToIce)
{
    const auto on = [](const char* ground)
    {
        return brakingWayM("<GlobalAction><EnvironmentAction><Environment name=\"e\"><RoadCondition "
                           "frictionScaleFactor=\"1\"><Properties><Property name=\"ground\" value=\"" +
                           std::string(ground) +
                           "\"/></Properties></RoadCondition></Environment></EnvironmentAction>"
                           "</GlobalAction>");
    };
    const double dry = on("dry"), wet = on("wet"), snow = on("snow 3"), ice = on("ice");
    EXPECT_DOUBLE_EQ(dry, brakingWayM(""));
    // The shares of the grip: 0.6, 0.3, 0.15.
    EXPECT_NEAR(wet / dry, 1.0 / 0.6, 0.15);
    EXPECT_NEAR(snow / wet, 2.0, 0.3);
    EXPECT_NEAR(ice / snow, 2.0, 0.4);
    EXPECT_DOUBLE_EQ(on("snow 3; cleared"), dry);
    EXPECT_DOUBLE_EQ(on("moist; snow 3; cleared"), wet);
}

TEST(RoadWeather, WhatFallsWetsAndWhitensTheRoad)
{
    const auto under = [](const char* type)
    {
        return brakingWayM("<GlobalAction><EnvironmentAction><Environment name=\"e\"><Weather><Precipitation "
                           "precipitationType=\"" +
                           std::string(type) +
                           "\" precipitationIntensity=\"2\"/></Weather></Environment></EnvironmentAction>"
                           "</GlobalAction>");
    };
    const double rain = under("rain");
    EXPECT_GT(rain, 1.4 * under("dry"));
    EXPECT_GT(under("snow"), 1.5 * rain);
}

TEST(RoadWeather, LeavesOtherGroundAlone)
{
    const simulation::WeatheredGround ground(
        std::make_shared<simulation::LevelGround>(3.0, simulation::GroundKind::grass), {0.5, true});
    const glm::dvec3 place(0.0);
    simulation::GroundPoint below;
    ground.below({&place, 1}, {&below, 1});
    EXPECT_EQ(below.kind, simulation::GroundKind::grass);
    EXPECT_EQ(below.gripScale, 1.0);
    EXPECT_EQ(below.heightM, 3.0);
}

} // namespace
