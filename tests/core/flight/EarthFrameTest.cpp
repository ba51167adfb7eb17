// SPDX-License-Identifier: Apache-2.0
#include "simulation/vehicle/EarthFrame.h"

#include <cmath>

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

// Moritz, Geodetic Reference System 1980 and WGS84's own constants: 9.7803253 at the equator, 9.8321849 at
// the poles.
TEST(EarthFrameTest, GravityIsThatOfTheEllipsoidAndPointsDown)
{
    for (const auto& [latitude, gravity] : {std::pair{0.0, 9.7803253}, std::pair{90.0, 9.8321849}})
    {
        const EarthFrame earth({latitude, 8.0, 0.0});
        EXPECT_NEAR(glm::length(earth.gravityAt(glm::dvec3(0.0))), gravity, 1e-6);
    }
    const EarthFrame earth({46.0, 8.0, 0.0});
    const glm::dvec3 gravity = earth.gravityAt(glm::dvec3(0.0));
    EXPECT_NEAR(gravity.x, 0.0, 1e-9);
    EXPECT_NEAR(gravity.y, 0.0, 1e-9);
    EXPECT_LT(gravity.z, -9.8);
}

TEST(EarthFrameTest, TheEarthFallsAwayFromThePlane)
{
    const EarthFrame earth({46.0, 8.0, 0.0});
    const EarthFrame::Place far = earth.placeAt({100000.0, 0.0, 0.0});
    EXPECT_NEAR(far.geodetic.heightM, 1e10 / (2.0 * 6.39e6), 2.0);
    EXPECT_NEAR(far.up.x, 100000.0 / 6.39e6, 1e-4);
    EXPECT_NEAR(glm::dot(far.up, far.north), 0.0, 1e-12);
}

TEST(EarthFrameTest, GeocentricLevelDiffersByTheDeviationOfTheVertical)
{
    const EarthFrame earth({45.0, 8.0, 0.0});
    const double angle =
        std::acos(glm::dot(earth.placeAt(glm::dvec3(0.0)).up, earth.geocentricPlaceAt(glm::dvec3(0.0)).up));
    EXPECT_NEAR(angle * 57.29578, 0.1924, 1e-3);
}

TEST(EarthFrameTest, AnglesAndAttitudesAreInverse)
{
    const EarthFrame earth({46.0, 8.0, 0.0});
    const EarthFrame::Place place = earth.placeAt({5000.0, -3000.0, 800.0});
    const LevelAngles angles = levelAngles(place, levelAttitude(place, 4.0, 0.3, -0.7));
    EXPECT_NEAR(angles.heading, 4.0, 1e-12);
    EXPECT_NEAR(angles.pitch, 0.3, 1e-12);
    EXPECT_NEAR(angles.roll, -0.7, 1e-12);
}

} // namespace
