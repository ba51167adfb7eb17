// SPDX-License-Identifier: Apache-2.0
// The lamps that pedals and gear lever of a road vehicle switch, and how far its wheels have turned.
#include <cmath>
#include <numbers>

#include "RoadSupport.h"

using namespace simulation;

namespace
{

EntityState shownOf(const RoadVehicle& vehicle)
{
    EntityState state;
    vehicle.writeParts(state);
    return state;
}

} // namespace

TEST(RoadVehicleLamps, FollowPedalAndGearLever)
{
    RoadVehicle car(testsupport::roadVehicle());
    const LevelGround ground;
    car.place({{}, 0.0, 0.0}, ground);
    testsupport::stepFor(car, ground, 0.1);
    EXPECT_FALSE(shownOf(car).lamps.at("brakeLights").isLit);
    EXPECT_FALSE(shownOf(car).lamps.at("reversingLights").isLit);
    testsupport::setInput(car, RoadInput::brake, 0.3);
    testsupport::setInput(car, RoadInput::gear, -1.0);
    testsupport::stepFor(car, ground, 2.0);
    EXPECT_TRUE(shownOf(car).lamps.at("brakeLights").isLit) << "standing on the pedal, too";
    EXPECT_TRUE(shownOf(car).lamps.at("reversingLights").isLit);
}

TEST(RoadVehicleLamps, HeadLampsFollowTheirSwitchAndAreElseLeftToTheDark)
{
    RoadVehicle car(testsupport::roadVehicle());
    const LevelGround ground;
    car.place({{}, 0.0, 0.0}, ground);
    EXPECT_FALSE(shownOf(car).lamps.contains("lowBeam"));
    testsupport::setInput(car, RoadInput::lights, 1.0);
    EXPECT_TRUE(shownOf(car).lamps.at("lowBeam").isLit);
    testsupport::setInput(car, RoadInput::lights, -1.0);
    EXPECT_FALSE(shownOf(car).lamps.at("lowBeam").isLit);
}

TEST(RoadVehicleLamps, WheelsTurnWithTheWayAndStandWhenLocked)
{
    RoadVehicle car(testsupport::roadVehicle());
    const LevelGround ground;
    car.place({{}, 0.0, 10.0}, ground);
    const auto turned = [&](double seconds)
    {
        const auto before = *shownOf(car).wheelTurnDeg;
        const double from = car.state().position.x;
        testsupport::stepFor(car, ground, seconds);
        const auto after = *shownOf(car).wheelTurnDeg;
        const double metres = car.state().position.x - from;
        const double radiusM = car.data().axles[1].tyre.radiusM;
        return std::pair{
            std::remainder(after[2] - before[2] - metres / radiusM * 180.0 / std::numbers::pi, 360.0),
            metres};
    };
    const auto [slipDeg, metres] = turned(0.1);
    EXPECT_GT(metres, 0.9);
    EXPECT_LT(std::abs(slipDeg), 0.05 * metres / 0.3 * 180.0 / std::numbers::pi) << "a free wheel rolls";
    testsupport::setInput(car, RoadInput::handbrake, 1.0);
    testsupport::stepFor(car, ground, 0.3);
    const double before = (*shownOf(car).wheelTurnDeg)[2];
    testsupport::stepFor(car, ground, 0.1);
    EXPECT_NEAR((*shownOf(car).wheelTurnDeg)[2], before, 1.0) << "a rear wheel that is locked slides";
    EXPECT_GT(car.readings().speedMps, 4.0);
}
