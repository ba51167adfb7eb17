// SPDX-License-Identifier: Apache-2.0
#include "simulation/environment/SunPosition.h"

#include <cmath>

#include <gtest/gtest.h>

namespace simulation
{
namespace
{

constexpr double kToleranceDeg = 0.02;

DateTime at(const char* text)
{
    return parseDateTime(text).value();
}

TEST(SunPosition, EquatorialPlaceOfMeeusExample25)
{
    // Meeus, example 25.b: 1992 October 13, 0 h TD: 13h13m30.763s, -7°47'01.74".
    const SunEquatorial sun = sunEquatorial(2448908.5);
    EXPECT_NEAR(sun.rightAscensionDeg, (13.0 + 13.0 / 60.0 + 30.763 / 3600.0) * 15.0, kToleranceDeg);
    EXPECT_NEAR(sun.declinationDeg, -(7.0 + 47.0 / 60.0 + 1.74 / 3600.0), kToleranceDeg);
}

TEST(SunPosition, SiderealTimeOfMeeusExample12)
{
    // Example 12.a: 1987 April 10, 0 h UT: 13h10m46.3668s.
    EXPECT_NEAR(greenwichSiderealDeg(at("1987-04-10T00:00:00Z").julianDay()),
                (13.0 + 10.0 / 60.0 + 46.3668 / 3600.0) * 15.0, 1e-5);
}

TEST(SunPosition, TopocentricPlaceOfTheSolarPositionAlgorithmsExample)
{
    // Reda and Andreas, NREL/TP-560-34302, table A5.1: azimuth 194.34024°, zenith 50.11162° with refraction
    // of 0.01632° (Golden, Colorado, 2003 October 17, 12:30:30, seven hours behind UTC).
    const SunDirection sun = sunDirection(at("2003-10-17T12:30:30-07:00"), 39.742476, -105.1786);
    EXPECT_NEAR(sun.azimuthDeg, 194.34024, kToleranceDeg);
    EXPECT_NEAR(sun.elevationDeg, 90.0 - 50.11162 - 0.01632, kToleranceDeg);
}

TEST(SunPosition, SolsticesReachTheTropics)
{
    // 2024: June 20, 20:51 UTC and December 21, 09:21 UTC; the obliquity then is 23.4362°.
    EXPECT_NEAR(sunEquatorial(at("2024-06-20T20:51:00Z").julianDay()).declinationDeg, 23.436, kToleranceDeg);
    EXPECT_NEAR(sunEquatorial(at("2024-12-21T09:21:00Z").julianDay()).declinationDeg, -23.436, kToleranceDeg);
}

TEST(SunPosition, EquinoxNoonStandsAtTheComplementOfTheLatitude)
{
    // 2024 March 20, 03:06 UTC is the equinox; noon at 133.6° E falls within minutes of it.
    EXPECT_NEAR(sunEquatorial(at("2024-03-20T03:06:00Z").julianDay()).declinationDeg, 0.0, kToleranceDeg);
    double highest = -90.0;
    for (int minute = 0; minute < 60; ++minute)
        highest = std::max(
            highest,
            sunDirection(at("2024-03-20T02:40:00Z").plusSeconds(60.0 * minute), 46.5, 133.6).elevationDeg);
    EXPECT_NEAR(highest, 90.0 - 46.5, kToleranceDeg);
}

TEST(SunPosition, NoonIsSouthInTheNorthAndNorthInTheSouth)
{
    EXPECT_NEAR(sunDirection(at("2024-06-21T11:30:00Z"), 46.5, 8.0).azimuthDeg, 180.0, 3.0);
    EXPECT_NEAR(std::remainder(sunDirection(at("2024-12-21T16:42:00Z"), -33.0, -70.5).azimuthDeg, 360.0), 0.0,
                3.0);
    EXPECT_LT(sunDirection(at("2024-06-21T23:30:00Z"), 46.5, 8.0).elevationDeg, -15.0);
}

TEST(SunPosition, TablesNoticeAMinuteOfTime)
{
    const SunDirection right = sunDirection(at("2003-10-17T19:30:30Z"), 39.742476, -105.1786);
    const SunDirection late = sunDirection(at("2003-10-17T19:31:30Z"), 39.742476, -105.1786);
    EXPECT_GT(std::fabs(right.azimuthDeg - late.azimuthDeg), 5.0 * kToleranceDeg);
}

TEST(DateTime, TextAndInstantAgree)
{
    EXPECT_EQ(at("1970-01-01T00:00:00Z").unixMilliseconds, 0);
    EXPECT_EQ(at("2025-06-13T06:00:00.250+02:00"), at("2025-06-13T04:00:00.25"));
    EXPECT_EQ(at("2025-06-13T06:00:00-0130"), at("2025-06-13T07:30:00Z"));
    EXPECT_EQ(formatDateTime(at("1969-12-31T23:59:59.999Z")), "1969-12-31T23:59:59.999Z");
    EXPECT_EQ(formatDateTime(at("2024-02-29T12:00:00Z")), "2024-02-29T12:00:00.000Z");
    EXPECT_DOUBLE_EQ(at("2000-01-01T12:00:00Z").julianDay(), 2451545.0);
    EXPECT_EQ(at("2024-01-01T00:00:00Z").plusSeconds(0.5).unixMilliseconds % 1000, 500);
}

TEST(DateTime, ImpossibleTextIsRefused)
{
    for (const char* text :
         {"", "2024", "2023-02-29T00:00:00Z", "2024-13-01T00:00:00Z", "2024-01-01T25:00:00Z",
          "2024-01-01 00:00:00", "2024-01-01T00:00:00.Z", "2024-01-01T00:00:00+99:00",
          "2024-01-01T00:00:00Zx", "2024-01-0aT00:00:00Z", "0000-01-01T00:00:00Z"})
        EXPECT_FALSE(parseDateTime(text)) << text;
}

} // namespace
} // namespace simulation
