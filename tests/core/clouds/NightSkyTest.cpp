// SPDX-License-Identifier: Apache-2.0
// Stars and moon stand where libastro of PyEphem 4.1.4 sees them (without refraction), and the moon has its
// phase.
#include "simulation/environment/NightSky.h"

#include <cmath>

#include <foundation/Angle.h>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "simulation/environment/BrightStars.h"

namespace
{

using namespace simulation;

struct Known
{
    const char* time;
    double latitudeDeg, longitudeDeg;
    double moonAzimuthDeg, moonElevationDeg, litShare;
    double vegaAzimuthDeg, vegaElevationDeg;
};

constexpr Known kKnown[] = {
    {"2024-06-21T22:00:00Z", 47.0, 8.0, 161.436, 11.454, 0.9980, 98.801, 66.140},
    {"2024-12-15T18:30:00Z", 47.0, 8.0, 76.806, 26.666, 0.9961, 299.286, 26.702},
    {"1987-04-12T03:00:00Z", -33.0, 151.0, 122.906, -43.833, 0.9552, 295.647, -39.376},
    {"2040-02-03T12:00:00Z", 60.0, -120.0, 178.525, 27.507, 0.7518, 70.881, 34.623},
    {"2026-03-03T12:00:00Z", 0.0, 0.0, 334.592, -83.150, 1.0000, 312.367, 21.589},
};

glm::dvec3 towards(double azimuthDeg, double elevationDeg)
{
    const double azimuth = foundation::radiansOf(azimuthDeg), elevation = foundation::radiansOf(elevationDeg);
    return {std::sin(azimuth) * std::cos(elevation), std::cos(azimuth) * std::cos(elevation),
            std::sin(elevation)};
}

double apartDeg(const glm::dvec3& a, const glm::dvec3& b)
{
    return foundation::degreesOf(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

} // namespace

TEST(NightSky, TheMoonStandsWhereItDoes)
{
    for (const Known& known : kKnown)
    {
        const MoonSight moon = moonSight(*parseDateTime(known.time), known.latitudeDeg, known.longitudeDeg);
        EXPECT_LT(apartDeg(moon.towards, towards(known.moonAzimuthDeg, known.moonElevationDeg)), 0.03)
            << known.time;
        EXPECT_NEAR(moon.litShare, known.litShare, 0.01) << known.time;
    }
}

TEST(NightSky, AMinuteLaterItWouldBeSeen)
{
    const Known& known = kKnown[0];
    const MoonSight moon =
        moonSight(parseDateTime(known.time)->plusSeconds(60.0), known.latitudeDeg, known.longitudeDeg);
    EXPECT_GT(apartDeg(moon.towards, towards(known.moonAzimuthDeg, known.moonElevationDeg)), 0.1);
}

TEST(NightSky, StarsStandWhereTheyDo)
{
    const double ascension = foundation::radiansOf(279.234733),
                 declination = foundation::radiansOf(38.783694);
    const glm::dvec3 vega(std::cos(declination) * std::cos(ascension),
                          std::cos(declination) * std::sin(ascension), std::sin(declination));
    for (const Known& known : kKnown)
        EXPECT_LT(
            apartDeg(worldFromStars(*parseDateTime(known.time), known.latitudeDeg, known.longitudeDeg) * vega,
                     towards(known.vegaAzimuthDeg, known.vegaElevationDeg)),
            0.02)
            << known.time;
}

TEST(NightSky, TheTableBeginsWithTheBrightest)
{
    const auto stars = brightStars();
    ASSERT_EQ(stars.size(), 890U);
    EXPECT_NEAR(stars.front().rightAscensionDeg, 101.29, 0.01) << "Sirius";
    EXPECT_NEAR(stars.front().declinationDeg, -16.72, 0.02);
    EXPECT_NEAR(stars.front().magnitude, -1.44, 0.01);
    for (const BrightStar& star : stars)
    {
        EXPECT_LE(star.magnitude, 4.5);
        EXPECT_LE(std::abs(star.declinationDeg), 90.0);
        EXPECT_LT(star.rightAscensionDeg, 360.0);
    }
}

TEST(NightSky, MoonlightFollowsThePhaseWithoutAStep)
{
    MoonSight moon;
    moon.towards = {0.0, 0.0, 1.0};
    double before = 0.0;
    for (int i = 0; i <= 200; ++i)
    {
        moon.litShare = i / 200.0;
        const double light = moonlightOf(moon);
        EXPECT_GE(light, before);
        before = light;
    }
    EXPECT_NEAR(before, 1.0, 1e-9);
    moon.litShare = 0.5;
    EXPECT_LT(moonlightOf(moon), 0.12) << "half a moon gives a tenth of the light";
    moon.towards = {0.0, 0.6, -0.8};
    EXPECT_EQ(moonlightOf(moon), 0.0) << "below the horizon";
}
