// SPDX-License-Identifier: Apache-2.0
#include "simulation/control/InputTrack.h"

#include <array>

#include <gtest/gtest.h>

namespace
{

using simulation::InputTrack;
using simulation::kInputNotGiven;
using simulation::parseInputs;

InputTrack parsed(const std::string& text)
{
    const auto track = parseInputs("osgtrainer-inputs 1\n" + text, "file");
    EXPECT_TRUE(track) << track.error().message();
    return track ? *track : InputTrack{};
}

std::string errorOf(const std::string& text)
{
    const auto track = parseInputs(text, "file");
    EXPECT_FALSE(track) << text;
    return track ? "" : track.error().message();
}

std::array<double, 2> at(const InputTrack& track, double place)
{
    std::array<double, 2> values{};
    track.valuesAt(place, values);
    return values;
}

TEST(InputTrack, HoldsValuesUntilTheNextRow)
{
    const InputTrack track = parsed("# taxi\ncolumns time a b\n1 0.5 -\n2 - 3 # then\n\nend 4\n");
    EXPECT_EQ(at(track, 0.999), (std::array{kInputNotGiven, kInputNotGiven}));
    EXPECT_EQ(at(track, 1.0), (std::array{0.5, kInputNotGiven}));
    EXPECT_EQ(at(track, 1.999), (std::array{0.5, kInputNotGiven}));
    EXPECT_EQ(at(track, 2.0), (std::array{0.5, 3.0}));
    EXPECT_EQ(at(track, 99.0), (std::array{0.5, 3.0}));
    EXPECT_EQ(track.end, 4.0);
}

TEST(InputTrack, RampedValuesGoStraight)
{
    const InputTrack track = parsed("ramped\ncolumns time a b\n0 0 1\n4 2 -\n");
    EXPECT_EQ(at(track, 1.0), (std::array{0.5, 1.0}));
    EXPECT_EQ(at(track, 4.0), (std::array{2.0, 1.0}));
}

TEST(InputTrack, StepsAreCountedOrTimed)
{
    const InputTrack timed = parsed("columns time a\n0 1\n");
    EXPECT_EQ(timed.placeOf(240, 1.0 / 120.0), 2.0);
    const InputTrack counted = parsed("rate 120\ncolumns step a\n0 1\n");
    EXPECT_EQ(counted.stepsPerSecond, 120);
    EXPECT_EQ(counted.placeOf(240, 1.0 / 120.0), 240.0);
}

TEST(InputTrack, WritesWhatItReads)
{
    const InputTrack track = parsed("rate 120\nramped\ncolumns step a b\n0 0.1 -\n7 1e-17 -2\nend 9\n");
    const auto again = parseInputs(writeInputs(track), "again");
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->rows[0].values[1], kInputNotGiven);
    EXPECT_EQ(again->rows[1].values, (std::vector<double>{1e-17, -2.0}));
    EXPECT_EQ(again->rows[1].at, 7.0);
    EXPECT_EQ(again->end, 9.0);
    EXPECT_TRUE(again->isRamped);
}

TEST(InputTrack, ErrorsNameTheLine)
{
    EXPECT_NE(errorOf("").find("osgtrainer-inputs 1"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 2\n").find("file:1"), std::string::npos);
    const std::string head = "osgtrainer-inputs 1\ncolumns time a\n";
    EXPECT_NE(errorOf(head).find("no row"), std::string::npos);
    EXPECT_NE(errorOf(head + "0 x\n").find("file:3: 'x'"), std::string::npos);
    EXPECT_NE(errorOf(head + "0 nan\n").find("file:3"), std::string::npos);
    EXPECT_NE(errorOf(head + "0 1e300\n").find("file:3"), std::string::npos);
    EXPECT_NE(errorOf(head + "0 1 2\n").find("3 cells, but 2 columns"), std::string::npos);
    EXPECT_NE(errorOf(head + "1 1\n1 2\n").find("file:4"), std::string::npos);
    EXPECT_NE(errorOf(head + "-1 1\n").find("file:3"), std::string::npos);
    EXPECT_NE(errorOf(head + "2 1\nend 1\n").find("file:4: 'end'"), std::string::npos);
    EXPECT_NE(errorOf(head + "2 1\nend 3\n4 1\n").find("file:5"), std::string::npos);
    EXPECT_NE(errorOf(head + "columns time b\n").find("twice"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 1\ncolumns time a a\n").find("twice"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 1\ncolumns step a\n").find("'time'"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 1\nrate 0\n").find("'rate'"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 1\n0 1\n").find("no word of the head"), std::string::npos);
    EXPECT_NE(errorOf("osgtrainer-inputs 1\nrate 120\ncolumns step a\n0.5 1\n").find("whole step"),
              std::string::npos);
}

} // namespace
