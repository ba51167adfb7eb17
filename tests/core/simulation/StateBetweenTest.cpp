// SPDX-License-Identifier: Apache-2.0
#include "simulation/player/StateBetween.h"

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

constexpr double kBetweenS = 0.01;

EntityState at(double x, double headingDeg, double wheelDeg)
{
    EntityState state;
    state.position = {x, 2.0, 3.0};
    state.velocity = {10.0, 0.0, 0.0};
    state.headingDeg = headingDeg;
    state.wheelRotationDeg = wheelDeg;
    return state;
}

TEST(StateBetween, GoesStraightAndTheShorterWayRound)
{
    const EntityState from = at(1.0, 179.0, 350.0), to = at(1.1, -177.0, 30.0);
    const EntityState half = stateBetween(from, to, 0.5, kBetweenS);
    EXPECT_NEAR(half.position.x, 1.05, 1e-12);
    EXPECT_NEAR(half.headingDeg, -179.0, 1e-9);
    EXPECT_NEAR(half.wheelRotationDeg, 10.0, 1e-9);
    EXPECT_NEAR(stateBetween(from, to, 0.125, kBetweenS).headingDeg, 179.5, 1e-9);
    EXPECT_EQ(stateBetween(from, to, 1.0, kBetweenS).headingDeg, to.headingDeg);
    EXPECT_NEAR(stateBetween(from, to, 0.0, kBetweenS).wheelRotationDeg, 350.0, 1e-9);
}

TEST(StateBetween, DoesNotSlideAcrossAJumpOrThroughAppearing)
{
    const EntityState from = at(1.0, 0.0, 0.0), far = at(500.0, 90.0, 0.0);
    EXPECT_EQ(stateBetween(from, far, 0.5, kBetweenS).position.x, 500.0);
    EntityState came = at(1.1, 0.0, 0.0), before = from;
    before.isPresent = false;
    EXPECT_EQ(stateBetween(before, came, 0.5, kBetweenS).position.x, 1.1);
    // The control: as fast as that, it is no jump.
    EntityState fast = from, fastFar = far;
    fast.velocity.x = fastFar.velocity.x = 49'900.0;
    EXPECT_NEAR(stateBetween(fast, fastFar, 0.5, kBetweenS).position.x, 250.5, 1e-9);
}

TEST(StateBetween, MovesThePartsOfAnAircraft)
{
    EntityState from = at(0.0, 0.0, 0.0), to = from;
    from.aircraft.emplace();
    to.aircraft.emplace();
    from.aircraft->propellerTurnDeg = 350.0;
    to.aircraft->propellerTurnDeg = 70.0;
    to.aircraft->flapDeg = 10.0;
    to.aircraft->hasBeacon = true;
    const EntityState half = stateBetween(from, to, 0.5, kBetweenS);
    EXPECT_NEAR(half.aircraft->propellerTurnDeg, 30.0, 1e-9);
    EXPECT_NEAR(half.aircraft->flapDeg, 5.0, 1e-12);
    EXPECT_TRUE(half.aircraft->hasBeacon);
}

} // namespace
