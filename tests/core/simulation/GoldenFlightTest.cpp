// SPDX-License-Identifier: Apache-2.0
// What a scenario does is one number: it changes with every change of what is flown, and with nothing else.
#include <cmath>
#include <cstdint>
#include <filesystem>

#include <foundation/Fnv1a.h>
#include <gtest/gtest.h>

#include "simulation/parser/ParseScenario.h"
#include "simulation/player/ScenarioPlayer.h"

namespace simulation
{
namespace
{

/// A hash of whole millimetres and thousandths of a degree: equal on every CPU, blind to the last bits of
/// libm.
class Hash
{
public:
    void add(double value, double unit)
    {
        const auto whole = static_cast<std::int64_t>(std::llround(value / unit));
        _hash.addNumber(static_cast<std::uint64_t>(whole), sizeof whole);
    }
    std::uint64_t value() const { return _hash.value(); }

private:
    foundation::Fnv1a _hash;
};

double ground(double east, double north)
{
    return 100.0 + 30.0 * std::sin(east / 200.0) * std::cos(north / 300.0);
}

std::uint64_t hashOf(Scenario scenario)
{
    PlayerOptions options;
    options.origin = Geodetic{43.6, 8.21, 0.0};
    options.clock = FixedClock(24);
    options.ground = [](double east, double north) { return GroundSample{ground(east, north)}; };
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    Hash hash;
    for (; player && !(*player)->isFinished(); (*player)->step())
        for (const EntityState& state : (*player)->entities())
        {
            for (int axis = 0; axis < 3; ++axis)
                hash.add(state.position[axis], 1e-3);
            for (const double angle : {state.headingDeg, state.pitchDeg, state.rollDeg})
                hash.add(angle, 1e-3);
            hash.add(state.speedMps, 1e-3);
        }
    return hash.value();
}

Scenario defaultScenario(const char* name)
{
    const auto parsed =
        readScenario(std::filesystem::path(OSGTRAINER_SOURCE_DIR) / "data" / "scenarios" / name);
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed ? parsed->scenario : Scenario{};
}

TEST(GoldenFlight, DefaultFlightIsFlownAsEver)
{
    EXPECT_EQ(hashOf(defaultScenario("flight.xosc")), 6757126941224661636u);
}

TEST(GoldenFlight, DefaultDriveIsDrivenAsEver)
{
    EXPECT_EQ(hashOf(defaultScenario("drive.xosc")), 11364760700676401614u);
}

TEST(GoldenFlight, TheNumberNoticesACentimetre)
{
    Scenario scenario = defaultScenario("flight.xosc");
    const std::uint64_t before = hashOf(scenario);
    EXPECT_EQ(hashOf(scenario), before);
    auto& follow = std::get<FollowTrajectoryAction>(scenario.storyboard.init.privates.at(0).actions.at(0));
    *std::get<GeoPosition>(std::get<Polyline>(follow.trajectory.shape).vertices.at(20).position).heightM +=
        0.01;
    EXPECT_NE(hashOf(scenario), before);
}

TEST(GoldenFlight, DefaultScenariosLastLongEnough)
{
    for (const char* name : {"flight.xosc", "drive.xosc"})
    {
        PlayerOptions options;
        options.origin = Geodetic{43.6, 8.21, 0.0};
        auto player = ScenarioPlayer::create(defaultScenario(name), options);
        ASSERT_TRUE(player);
        while (!(*player)->isFinished())
            (*player)->step();
        EXPECT_GE((*player)->timeS(), 12.0);
        EXPECT_GT((*player)->entities().at(0).odometerM, 100.0);
    }
}

} // namespace
} // namespace simulation
