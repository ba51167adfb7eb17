// SPDX-License-Identifier: Apache-2.0
// Trailers that are coupled and left: places worked by hand.
#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

constexpr double kHitchM = -1.0, kCouplerM = 4.0;

std::string withHitch(const std::string& inner)
{
    std::string vehicle = kCar;
    return vehicle.replace(vehicle.find("<Properties/>"), 13, "<Properties/>" + inner);
}

std::string trailerAction(const std::string& inner)
{
    return "<PrivateAction><TrailerAction>" + inner + "</TrailerAction></PrivateAction>";
}

/// Ego at the origin, at 10 m/s along x; a trailer stands 30 m beside it. It is coupled at 1 s and left at 3
/// s.
ScenarioText coupling()
{
    ScenarioText text;
    text.entities = R"(<ScenarioObject name="Ego">)" + withHitch(R"(<TrailerHitch dx="-1.0"/>)") +
                    R"(</ScenarioObject><ScenarioObject name="Cart">)" +
                    withHitch(R"(<TrailerCoupler dx="4.0"/>)") + "</ScenarioObject>";
    text.globals = R"(<Private entityRef="Cart">)" +
                   teleport(R"(<WorldPosition x="0" y="30" z="0" h="0"/>)") + "</Private>";
    text.privates = teleport(R"(<WorldPosition x="0" y="0" z="0" h="0"/>)") + speedAction(10.0);
    text.stories = story(
        event("couple", trailerAction(R"(<ConnectTrailerAction trailerRef="Cart"/>)"), timeCondition(1.0)) +
        event("leave", trailerAction("<DisconnectTrailerAction/>"), timeCondition(3.0)));
    text.stop = stopAt(10.0);
    return text;
}

/// The cart at a time.
EntityState cartAt(double timeS, const ScenarioText& text = coupling())
{
    auto parsed = parseScenario(text.text(), "test.xosc", {});
    EXPECT_TRUE(parsed) << parsed.error().message();
    PlayerOptions options;
    options.clock = FixedClock::forStep(0.01);
    auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    while ((*player)->timeS() < timeS - 1e-9)
        (*player)->step();
    return (*player)->entities()[1];
}

} // namespace

TEST(TrailerAction, CouplesATrailerAndLeavesItWhereItIs)
{
    EXPECT_EQ(cartAt(0.9).position, glm::dvec3(0.0, 30.0, 0.0)) << "not coupled yet";
    const EntityState drawn = cartAt(2.9);
    const glm::dvec3 hitch(29.0 + kHitchM, 0.0, 0.0);
    const glm::dvec3 coupler = drawn.position + drawn.bodyToLocal()[0] * kCouplerM;
    EXPECT_LT(glm::distance(coupler, hitch), 0.11) << "the coupler is at the hitch, one step apart at most";
    EXPECT_NEAR(drawn.speedMps, 10.0, 1e-9);
    const EntityState left = cartAt(3.1), later = cartAt(8.0);
    EXPECT_EQ(left.position, later.position);
    EXPECT_GT(glm::distance(drawn.position, cartAt(2.0).position), 5.0) << "it was drawn before";
}

TEST(TrailerAction, WithoutTheActionTheTrailerStays)
{
    ScenarioText text = coupling();
    text.stories = story(event("wait", speedAction(10.0), timeCondition(1.0)));
    EXPECT_EQ(cartAt(2.9, text).position, glm::dvec3(0.0, 30.0, 0.0));
}

} // namespace simulation
