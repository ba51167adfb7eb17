// SPDX-License-Identifier: Apache-2.0
// The height of what follows a trajectory beside a road: near it the road's, far from it the ground's.
#include "RoadPlay.h"

namespace simulation
{
namespace
{

constexpr double kGroundM = 7.0; ///< the road lies at 0

/// A car goes along the road, at a distance from its middle, over ground that is 7 m higher; returns its
/// height.
double heightBeside(double leftM)
{
    const std::string y = " y=\"" + std::to_string(leftM) + "\"/>";
    ScenarioText text;
    text.privates = followTrajectory(vertex("<WorldPosition x=\"100\"" + y, "0") +
                                         vertex("<WorldPosition x=\"130\"" + y, "3"),
                                     kTiming, "follow");
    text.stop = stopAt(10.0);
    auto parsed = parseScenario(text.text(), "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    PlayerOptions options;
    options.clock = FixedClock::forStep(roadplay::kStepS);
    options.roads = roadplay::straight();
    options.ground = [](double, double, double) { return std::optional(GroundSample{kGroundM}); };
    const auto player = ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    roadplay::playTo(**player, 2.0);
    const double during = (*player)->entities()[0].position.z;
    roadplay::playTo(**player, 5.0);
    EXPECT_NEAR((*player)->entities()[0].position.z, during, 1e-9) << "after its end, too";
    return during;
}

TEST(BesideRoads, ATrajectoryOnTheRoadLiesOnIt)
{
    EXPECT_NEAR(heightBeside(-1.75), 0.0, 1e-9);
    EXPECT_NEAR(heightBeside(-12.0), 0.0, 1e-9) << "8.5 m beside its lanes";
}

TEST(BesideRoads, ATrajectoryFarFromTheRoadLiesOnTheGround)
{
    EXPECT_NEAR(heightBeside(-40.0), kGroundM, 1e-9);
    EXPECT_NEAR(heightBeside(40.0), kGroundM, 1e-9);
}

} // namespace
} // namespace simulation
