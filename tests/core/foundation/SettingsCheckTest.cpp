// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <string>

#include <foundation/SettingsCheck.h>
#include <gtest/gtest.h>

namespace
{

using foundation::SettingsCheck;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool isWithin(double value)
{
    return bool(SettingsCheck("s").within("f", value, 0.0, 1.0).outcome());
}

bool isAbove(double value)
{
    return bool(SettingsCheck("s").above("f", value, 0.0).outcome());
}

TEST(SettingsCheck, AcceptsTheEndsOfARange)
{
    EXPECT_TRUE(isWithin(0.0));
    EXPECT_TRUE(isWithin(1.0));
    EXPECT_TRUE(isAbove(std::numeric_limits<double>::min()));
    EXPECT_TRUE(isAbove(std::numeric_limits<double>::max()));
}

TEST(SettingsCheck, RefusesWhatIsOutsideNotANumberOrInfinite)
{
    for (const double wrong : {-1e-9, 1.0 + 1e-9, std::nan(""), kInfinity, -kInfinity})
        EXPECT_FALSE(isWithin(wrong)) << wrong;
    for (const double wrong : {0.0, -1.0, std::nan(""), kInfinity, -kInfinity})
        EXPECT_FALSE(isAbove(wrong)) << wrong;
    EXPECT_FALSE(SettingsCheck("s").within("f", kInfinity, 0.0).outcome());
}

TEST(SettingsCheck, KeepsTheFirstErrorAndNamesItsField)
{
    SettingsCheck check("camera");
    check.within("tilt", 0.5, 0.0, 1.0).within("pan", 3.0, 0.0, 1.0).above("zoom", 0.0, 0.0);
    const auto outcome = check.outcome();
    ASSERT_FALSE(outcome);
    EXPECT_EQ(outcome.error().message(), "camera.pan: is 3; give a number from 0 to 1");
}

TEST(SettingsCheck, TellsOpenRangesInWords)
{
    EXPECT_EQ(SettingsCheck("s").above("f", 0.0, 0.0).outcome().error().remedy,
              "give a finite number above 0");
    EXPECT_EQ(SettingsCheck("s").above("f", 2.0, 0.0, 1.0).outcome().error().remedy,
              "give a number above 0, at most 1");
    EXPECT_EQ(SettingsCheck("s").within("f", -1.0, 0.0).outcome().error().remedy,
              "give a finite number of at least 0");
    EXPECT_EQ(
        SettingsCheck("s").require(false, "f", "is odd", "give an even one").outcome().error().message(),
        "s.f: is odd; give an even one");
}

} // namespace
