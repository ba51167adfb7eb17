// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/player/SpeedProfile.h"

namespace simulation
{
namespace
{

constexpr Geodetic kOrigin{46.5, 8.0, 0.0};

std::unique_ptr<ScenarioPlayer> playing(const std::string& text, PlayerOptions options = {})
{
    auto parsed = parseScenario(text, "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    if (!parsed) return nullptr;
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

void playTo(ScenarioPlayer& player, double timeS)
{
    while (!player.isFinished() && player.timeS() < timeS - 1e-9)
        player.step();
}

const std::string kAirborne =
    R"(<ScenarioObject name="Ego"><MiscObject name="m" miscObjectCategory="none" mass="1"><BoundingBox><Center x="0" y="0" z="0"/>
<Dimensions width="1" length="2" height="3"/></BoundingBox><Properties><Property name="domain" value="air"/></Properties></MiscObject></ScenarioObject>)";

TEST(FixedClock, DoesNotDrift)
{
    FixedClock clock(120);
    for (int i = 0; i < 120 * 3600; ++i)
        clock.advance();
    EXPECT_EQ(clock.seconds(), 3600.0);
    EXPECT_EQ(FixedClock::forFrameRate(24).stepsPerSecond(), 120);
    EXPECT_EQ(FixedClock::forFrameRate(60).stepsPerSecond(), 120);
    EXPECT_EQ(FixedClock::forFrameRate(25).stepsPerSecond(), 100);
    EXPECT_EQ(FixedClock::forFrameRate(240).stepsPerSecond(), 240);
}

TEST(SpeedProfile, EveryShapeReachesItsTargetAndItsDistanceIsTheIntegral)
{
    for (const DynamicsShape shape : {DynamicsShape::linear, DynamicsShape::cubic, DynamicsShape::sinusoidal})
        for (const DynamicsDimension dimension :
             {DynamicsDimension::time, DynamicsDimension::distance, DynamicsDimension::rate})
        {
            const SpeedProfile profile(4.0, 16.0, {shape, dimension, 3.0});
            EXPECT_DOUBLE_EQ(profile.speedAt(profile.durationS()), 16.0);
            double distance = 0.0;
            double steepest = 0.0;
            const int pieces = 20'000;
            const double end = profile.durationS() + 1.0;
            for (int i = 0; i < pieces; ++i)
            {
                const double from = end * i / pieces;
                const double to = end * (i + 1) / pieces;
                distance += 0.5 * (profile.speedAt(from) + profile.speedAt(to)) * (to - from);
                steepest = std::max(steepest, (profile.speedAt(to) - profile.speedAt(from)) / (to - from));
            }
            EXPECT_NEAR(distance, profile.distanceAt(end), 1e-5);
            const double reached = dimension == DynamicsDimension::time ? profile.durationS()
                                   : dimension == DynamicsDimension::distance
                                       ? profile.distanceAt(profile.durationS())
                                       : steepest;
            EXPECT_NEAR(reached, 3.0, 1e-3);
        }
    EXPECT_EQ(SpeedProfile(4.0, 16.0, {}).speedAt(0.0), 16.0);
    EXPECT_EQ(SpeedProfile(4.0, 16.0, {DynamicsShape::linear, DynamicsDimension::rate, 0.0}).speedAt(1e9),
              4.0);
}

TEST(Player, SpeedActionMovesAlongTheHeading)
{
    ScenarioText text;
    text.privates = teleport("<WorldPosition x=\"1\" y=\"2\" z=\"3\" h=\"1.5707963267948966\"/>") +
                    speedAction(10.0, "linear", "time", 2.0);
    const auto player = playing(text.text());
    playTo(*player, 3.0);
    const EntityState& state = player->entities().at(0);
    EXPECT_NEAR(state.position.x, 1.0, 1e-9);
    EXPECT_NEAR(state.position.y, 2.0 + 10.0 + 10.0, 1e-9);
    EXPECT_NEAR(state.position.z, 3.0, 1e-9);
    EXPECT_NEAR(state.speedMps, 10.0, 1e-12);
    EXPECT_NEAR(state.compassDeg(), 0.0, 1e-9);
    EXPECT_NEAR(state.wheelRotationDeg, std::fmod(foundation::degreesOf(20.0 / 0.4), 360.0), 1e-6);
    EXPECT_NEAR(glm::length(state.velocity - glm::dvec3(0, 10, 0)), 0.0, 1e-9);
}

TEST(Player, APlaceOnARoadNeedsALogicFile)
{
    Scenario scenario;
    scenario.entities.push_back({{}, "Car", MiscObject{}});
    scenario.storyboard.init.privates.push_back({{}, "Car", {TeleportAction{{7}, LanePosition{}}}});
    const auto player = ScenarioPlayer::create(scenario, {});
    ASSERT_FALSE(player);
    EXPECT_EQ(player.error().message(), "scenario:7: a place on a road, but RoadNetwork names no LogicFile; "
                                        "name the OpenDRIVE file there");
}

TEST(Player, GeoPositionIsPlacedInTheLocalFrame)
{
    ScenarioText text;
    text.entities = kAirborne;
    text.privates = teleport("<GeoPosition latitudeDeg=\"46.509\" longitudeDeg=\"8\" height=\"1000\"/>");
    PlayerOptions options;
    options.origin = kOrigin;
    const auto player = playing(text.text(), options);
    // 0.009° of the meridian at 46.5°: the radius of curvature there is 6 369 116 m; 1000 m up; curvature
    // takes 8 cm.
    EXPECT_NEAR(player->entities().at(0).position.x, 0.0, 1e-6);
    EXPECT_NEAR(player->entities().at(0).position.y, (6'369'116.0 + 1000.0) * foundation::radiansOf(0.009),
                0.02);
    EXPECT_NEAR(player->entities().at(0).position.z, 1000.0 - 0.0786, 1e-3);
    const auto parsed = parseScenario(text.text(), "test.xosc");
    const auto homeless = ScenarioPlayer::create(parsed->scenario, {});
    ASSERT_FALSE(homeless);
    EXPECT_NE(homeless.error().what.find("georeference"), std::string::npos);
}

TEST(Player, TimedVerticesAreMetAtTheirTimes)
{
    ScenarioText text;
    text.entities = kAirborne;
    const std::string vertices = vertex("<WorldPosition x=\"0\" y=\"0\" z=\"0\"/>", "0") +
                                 vertex("<WorldPosition x=\"100\" y=\"0\" z=\"10\"/>", "2") +
                                 vertex("<WorldPosition x=\"150\" y=\"80\" z=\"10\"/>", "3.5") +
                                 vertex("<WorldPosition x=\"100\" y=\"160\" z=\"0\"/>", "6");
    for (const char* mode : {"position", "follow"})
    {
        text.privates = followTrajectory(
            vertices, R"(<Timing domainAbsoluteRelative="relative" scale="2" offset="1"/>)", mode);
        const auto player = playing(text.text());
        playTo(*player, 0.5);
        EXPECT_EQ(player->entities().at(0).position, glm::dvec3(0.0)) << "waits for the first vertex's time";
        EXPECT_EQ(player->entities().at(0).speedMps, 0.0);
        playTo(*player, 5.0);
        EXPECT_NEAR(glm::length(player->entities().at(0).position - glm::dvec3(100, 0, 10)), 0.0, 1e-9);
        playTo(*player, 8.0);
        EXPECT_NEAR(glm::length(player->entities().at(0).position - glm::dvec3(150, 80, 10)), 0.0, 1e-9);
        playTo(*player, 13.0);
        EXPECT_NEAR(glm::length(player->entities().at(0).position - glm::dvec3(100, 160, 0)), 0.0, 1e-9);
        const double speed = player->entities().at(0).speedMps;
        playTo(*player, 14.0);
        EXPECT_NEAR(glm::length(player->entities().at(0).position - glm::dvec3(100, 160, 0)), speed, 1e-6);
    }
}

TEST(Player, AnAirborneEntityBanksIntoItsTurn)
{
    ScenarioText text;
    text.entities = kAirborne;
    std::string vertices;
    for (int i = 0; i <= 20; ++i) // a left turn of radius 500 m at 50 m/s
        vertices += vertex("<WorldPosition x=\"" + std::to_string(500.0 * std::sin(i * 0.1)) + "\" y=\"" +
                               std::to_string(500.0 - 500.0 * std::cos(i * 0.1)) + "\" z=\"" +
                               std::to_string(5.0 * i) + "\"/>",
                           std::to_string(i));
    text.privates = followTrajectory(vertices, kTiming, "follow");
    const auto player = playing(text.text());
    playTo(*player, 10.0);
    const EntityState& state = player->entities().at(0);
    EXPECT_NEAR(state.rollDeg, -foundation::degreesOf(std::atan(50.0 * 50.0 / 500.0 / 9.80665)), 0.05);
    EXPECT_NEAR(state.pitchDeg, -foundation::degreesOf(std::atan(0.1)), 0.05);
    EXPECT_NEAR(state.headingDeg, foundation::degreesOf(1.0), 0.05);
    const glm::dmat3 body = state.bodyToLocal();
    EXPECT_GT(body[0].z, 0.0) << "nose up";
    EXPECT_LT(body[1].z, 0.0) << "left wing down";
    EXPECT_NEAR(glm::determinant(body), 1.0, 1e-12);
    EXPECT_NEAR(glm::length(glm::normalize(state.velocity) - body[0]), 0.0, 1e-3);
}

TEST(Player, AClosedPathIsRunAgainAndAgain)
{
    ScenarioText text;
    text.privates = speedAction(10.0) + followTrajectory(vertex("<WorldPosition x=\"0\" y=\"0\"/>") +
                                                             vertex("<WorldPosition x=\"30\" y=\"0\"/>") +
                                                             vertex("<WorldPosition x=\"30\" y=\"40\"/>"),
                                                         "<None/>", "position", "true");
    const auto player = playing(text.text());
    playTo(*player, 12.0 * 3.0 + 3.5); // three rounds of 120 m, then 35 m
    EXPECT_NEAR(glm::length(player->entities().at(0).position - glm::dvec3(30, 5, 0)), 0.0, 1e-6);
}

TEST(Player, AGroundVehicleStandsOnItsWheels)
{
    ScenarioText text;
    text.privates = teleport("<WorldPosition x=\"10\" y=\"20\" h=\"0.5\"/>");
    PlayerOptions options;
    options.ground = [](double east, double north) { return GroundSample{5.0 + 0.1 * east - 0.2 * north}; };
    const auto player = playing(text.text(), options);
    const EntityState& state = player->entities().at(0);
    EXPECT_TRUE(state.isOnGround);
    EXPECT_NEAR(state.position.z, 5.0 + 1.0 - 4.0, 1e-9);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.1, 0.2, 1.0));
    EXPECT_NEAR(glm::length(state.bodyToLocal()[2] - normal), 0.0, 1e-9);
    for (const double travel : state.wheelTravelM)
        EXPECT_NEAR(travel, 0.0, 1e-9);
}

TEST(Player, ABumpUnderOneWheelShowsInItsTravel)
{
    ScenarioText text;
    text.privates = teleport("<WorldPosition x=\"0\" y=\"0\" h=\"0\"/>");
    PlayerOptions options;
    options.ground = [](double east, double north)
    { return GroundSample{east > 1.0 && north > 0.0 ? 0.04 : 0.0}; };
    const auto player = playing(text.text(), options);
    const EntityState& state = player->entities().at(0);
    EXPECT_NEAR(state.wheelTravelM[0], 0.01, 1e-9);
    EXPECT_NEAR(state.wheelTravelM[1], -0.01, 1e-9);
    EXPECT_LT(state.pitchDeg, 0.0) << "nose up";
    EXPECT_GT(state.rollDeg, 0.0) << "left side up";
    options.ground = [](double, double) -> std::optional<GroundSample> { return std::nullopt; };
    EXPECT_FALSE(playing(text.text(), options)->entities().at(0).isOnGround);
}

/// Ground at 0 and a deck 6 m above it, from x = 20 to 40: what is more than 1 m below the deck stays below.
std::optional<GroundSample> underADeck(double east, double, double from)
{
    return GroundSample{east > 20.0 && east < 40.0 && from > 5.0 ? 6.0 : 0.0};
}

TEST(Player, AVehicleUnderABridgeStaysBelowAndOnTheBridgeAbove)
{
    for (const double startM : {0.0, 6.0})
    {
        ScenarioText text;
        text.privates = teleport("<WorldPosition x=\"23\" y=\"0\" z=\"" + std::to_string(startM) + "\"/>") +
                        speedAction(13.0);
        PlayerOptions options;
        options.ground = underADeck;
        const auto player = playing(text.text(), options);
        for (double time = 0.0; time < 0.95; time += 0.05)
        {
            playTo(*player, time);
            EXPECT_NEAR(player->entities().at(0).position.z, startM, 1e-9) << time;
        }
        EXPECT_GT(player->entities().at(0).position.x, 34.0);
    }
}

TEST(Player, AnAirborneEntityDoesNotSnapToTheGround)
{
    ScenarioText text;
    text.entities = kAirborne;
    text.privates = teleport("<WorldPosition x=\"0\" y=\"0\" z=\"50\"/>");
    PlayerOptions options;
    options.ground = [](double, double) { return GroundSample{7.0}; };
    options.origin = kOrigin;
    EXPECT_EQ(playing(text.text(), options)->entities().at(0).position.z, 50.0);
    text.privates = teleport("<GeoPosition latitudeDeg=\"46.5\" longitudeDeg=\"8\" altitude=\"20\"/>");
    EXPECT_NEAR(playing(text.text(), options)->entities().at(0).position.z, 27.0, 1e-9);
    text.privates = teleport("<GeoPosition latitudeDeg=\"46.5\" longitudeDeg=\"8\"/>");
    EXPECT_NEAR(playing(text.text(), options)->entities().at(0).position.z, 7.0, 1e-9);
}

TEST(Player, EnvironmentGoesOnWithTheDayUntilTheSunIsGiven)
{
    const auto environment = [](const std::string& content)
    {
        return "<GlobalAction><EnvironmentAction><Environment name=\"e\">" + content +
               "</Environment></EnvironmentAction></GlobalAction>";
    };
    ScenarioText text;
    text.globals = environment("<TimeOfDay animation=\"true\" dateTime=\"2024-06-21T11:29:50Z\"/><Weather "
                               "cloudState=\"free\"><Fog visualRange=\"5000\"/></Weather>");
    text.stories = story(event(
        "sun", environment("<Weather><Sun azimuth=\"1.5707963267948966\" elevation=\"0.5\"/></Weather>"),
        timeCondition(5.0)));
    text.stop = stopAt(9.0);
    PlayerOptions options;
    options.origin = kOrigin;
    const auto player = playing(text.text(), options);
    EXPECT_EQ(player->environment().fogVisualRangeM, 5000.0);
    EXPECT_NEAR(player->environment().sun.azimuthDeg, 180.0, 2.0);
    const double before = player->environment().sun.azimuthDeg;
    playTo(*player, 4.0);
    EXPECT_GT(player->environment().sun.azimuthDeg, before);
    playTo(*player, 6.0);
    EXPECT_NEAR(player->environment().sun.azimuthDeg, 90.0, 1e-9);
    EXPECT_EQ(player->environment().fogVisualRangeM, 5000.0);
    EXPECT_EQ(formatDateTime(player->environment().dateTime), "2024-06-21T11:29:56.000Z");
}

} // namespace
} // namespace simulation
