// SPDX-License-Identifier: Apache-2.0
// What breaks or slows, by hand.
#include "simulation/contact/GivingContact.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

TEST(GivingContact, OverlapsByThePlanAndTheHeight)
{
    HullPlan hull;
    hull.halfM = {2.0, 1.0};
    Obstacle box;
    box.halfM = {1.0, 0.5};
    box.middle = {2.9, 0.0};
    EXPECT_TRUE(overlaps(hull, box));
    box.middle = {3.1, 0.0};
    EXPECT_FALSE(overlaps(hull, box));
    // Turned by 45° its corner reaches sqrt(1/2) * 1.5 = 1.06 m.
    box.along = glm::dvec2(std::sqrt(0.5));
    box.middle = {3.0, 0.0};
    EXPECT_TRUE(overlaps(hull, box));
    box.lowM = 1.5;
    box.highM = 2.0;
    EXPECT_FALSE(overlaps(hull, box)) << "above it";
    Obstacle round;
    round.isRound = true;
    round.halfM = glm::dvec2(0.5);
    round.middle = {2.3, 1.3};
    EXPECT_TRUE(overlaps(hull, round));
    round.middle = {2.4, 1.4};
    EXPECT_FALSE(overlaps(hull, round)) << "beyond the corner";
}

TEST(GivingContact, TakesNoMoreThanStopsIt)
{
    // A post takes 600 N s: 0.4 m/s of 1 500 kg.
    const GivingBlow fast = blowOf(ObstacleKind::post, 10.0, 1500.0, 1.0 / 1500.0, 1.0 / 120.0);
    EXPECT_EQ(fast.impulseNs, 600.0);
    EXPECT_TRUE(fast.breaks);
    const GivingBlow slow = blowOf(ObstacleKind::post, 0.3, 1500.0, 1.0 / 1500.0, 1.0 / 120.0);
    EXPECT_NEAR(slow.impulseNs, 450.0, 1e-9);
    EXPECT_FALSE(slow.breaks) << "it stands fast";
    const GivingBlow hedge = blowOf(ObstacleKind::hedge, 10.0, 1500.0, 1.0 / 1500.0, 1.0 / 120.0);
    EXPECT_NEAR(hedge.impulseNs, 1500.0 / 120.0 * (0.02 * 100.0 + 1.5), 1e-9);
    EXPECT_FALSE(hedge.breaks);
}

} // namespace
