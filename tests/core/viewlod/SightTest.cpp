// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <viewlod/Sight.h>

namespace
{

using viewlod::Sight;
using viewlod::ViewState;

const glm::dvec3 kSightEye(10.0, 20.0, 30.0);

/// 60 degrees wide and high, from kSightEye.
ViewState lookingAlong(const glm::dvec3& ahead)
{
    return ViewState::fromMatrices(glm::lookAt(kSightEye, kSightEye + ahead, glm::dvec3(0, 0, 1)),
                                   glm::perspective(glm::radians(60.0), 1.0, 1.0, 1000.0), 500, 500);
}

/// Whether a point in the plan, so many degrees to the left of north, is in sight.
bool seesAt(const Sight& sight, double degrees, double distanceM = 100.0)
{
    const double angle = glm::radians(90.0 + degrees);
    return sight.touches(kSightEye + distanceM * glm::dvec3(std::cos(angle), std::sin(angle), 0.0), 0.0);
}

TEST(Sight, WithoutACameraIsEverything)
{
    const Sight sight;
    EXPECT_TRUE(sight.isEverything());
    EXPECT_TRUE(seesAt(sight, 180.0));
}

TEST(Sight, IsTheFrustumAndItsMargin)
{
    for (const double marginDeg : {0.0, 5.0, 40.0})
    {
        Sight sight;
        sight.add(lookingAlong({0, 1, 0}), glm::radians(marginDeg));
        EXPECT_FALSE(sight.isEverything());
        for (double degrees = 0.0; degrees < 180.0; degrees += 1.0)
            if (std::abs(degrees - 30.0 - marginDeg) > 0.5)
            {
                EXPECT_EQ(seesAt(sight, degrees), degrees < 30.0 + marginDeg) << marginDeg << ", " << degrees;
                EXPECT_EQ(seesAt(sight, -degrees), seesAt(sight, degrees));
            }
        EXPECT_TRUE(seesAt(sight, 0.0, 0.5)) << "the near plane does not count";
        EXPECT_FALSE(seesAt(sight, 0.0, 1001.0)) << "the far plane does";
    }
}

TEST(Sight, WhoseSidesAreHalfATurnApartLetsEverythingInOnTheLand)
{
    Sight sight;
    sight.add(lookingAlong({0, 1, 0}), glm::radians(60.0));
    EXPECT_TRUE(seesAt(sight, 180.0));
    EXPECT_TRUE(seesAt(sight, 90.0));
}

TEST(Sight, OfTwoCamerasIsThatOfEach)
{
    Sight sight, west;
    sight.add(lookingAlong({0, 1, 0}), 0.0);
    west.add(lookingAlong({-1, 0, 0}), 0.0);
    sight.add(west);
    EXPECT_TRUE(seesAt(sight, 0.0));
    EXPECT_TRUE(seesAt(sight, 90.0));
    EXPECT_FALSE(seesAt(sight, 45.0));
    EXPECT_FALSE(seesAt(sight, -90.0));
    EXPECT_NE(sight, west);
}

TEST(Sight, HoldsEveryBallAroundOneThatItHolds)
{
    Sight sight;
    sight.add(lookingAlong({0.3, 1, -0.2}), glm::radians(7.0));
    int held = 0;
    for (int i = 0; i < 20000; ++i)
    {
        const auto unit = [&](int k) { return std::fmod((i + 1) * (0.6180339887 + 0.1 * k), 1.0); };
        const glm::dvec3 centre = kSightEye + 400.0 * (glm::dvec3(unit(0), unit(1), unit(2)) - 0.5);
        const double radius = 30.0 * unit(3);
        const glm::dvec3 aside = 20.0 * (glm::dvec3(unit(4), unit(5), unit(6)) - 0.5);
        if (!sight.touches(centre, radius)) continue;
        ++held;
        ASSERT_TRUE(sight.touches(centre + aside, radius + glm::length(aside) + 1e-9)) << i;
    }
    EXPECT_GT(held, 1000);
    EXPECT_LT(held, 19000) << "nothing was ever out of sight";
}

} // namespace
