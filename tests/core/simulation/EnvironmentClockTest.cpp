// SPDX-License-Identifier: Apache-2.0
// What an unsaid sky is like, and which of scenario, world and usual goes first.
#include <utility>

#include <gtest/gtest.h>

#include "simulation/state/EnvironmentState.h"

namespace simulation
{
namespace
{

/// Round the Earth it is forenoon where a scenario says nothing; it was deep night over America.
TEST(EnvironmentClock, BeginsByDayAtEveryLongitude)
{
    for (const double longitudeDeg : {-170.0, -105.0, -74.0, 0.0, 8.0, 77.0, 139.0, 175.0})
        EXPECT_GT(EnvironmentClock(Geodetic{40.0, longitudeDeg, 0.0}).at(0.0).sun.elevationDeg, 40.0)
            << longitudeDeg;
    EXPECT_EQ(EnvironmentClock(Geodetic{46.0, 14.9, 0.0}).at(0.0).dateTime,
              EnvironmentClock(std::nullopt).at(0.0).dateTime)
        << "within 15 degrees of Greenwich it is 10:00 UTC";
}

TEST(EnvironmentClock, LampsBurnFromThreeDegreesOfTheSunDown)
{
    EnvironmentState environment;
    for (const auto& [elevationDeg, dark] :
         {std::pair{60.0, false}, {3.1, false}, {2.9, true}, {-30.0, true}})
    {
        environment.sun.elevationDeg = elevationDeg;
        EXPECT_EQ(isDark(environment), dark) << elevationDeg;
    }
}

TEST(EnvironmentClock, TheScenarioGoesBeforeTheWorldAndTheWorldBeforeTheDefault)
{
    const WorldAir world{SunDirection{180.0, -20.0}, 5000.0};
    EnvironmentClock clock(Geodetic{46.0, 8.0, 0.0}, world);
    EXPECT_EQ(clock.at(0.0).sun.elevationDeg, -20.0);
    EXPECT_EQ(clock.at(0.0).fogVisualRangeM, 5000.0);
    Environment fog;
    fog.weather.emplace();
    fog.weather->fogVisualRangeM = 200.0;
    clock.apply(fog, 1.0);
    EXPECT_EQ(clock.at(1.0).fogVisualRangeM, 200.0);
    EXPECT_EQ(clock.at(1.0).sun.elevationDeg, -20.0) << "an action changes only what it contains";
    Environment noon;
    noon.timeOfDay = TimeOfDay{*parseDateTime("2024-06-21T11:30:00Z"), false};
    clock.apply(noon, 2.0);
    EXPECT_GT(clock.at(2.0).sun.elevationDeg, 60.0);
}

} // namespace
} // namespace simulation
