// SPDX-License-Identifier: Apache-2.0
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "FlightSupport.h"

namespace
{

using testing::HasSubstr;

std::string wholeFile()
{
    std::ifstream stream(testsupport::kAircraftFile);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(AircraftFileTest, ReadsTheAircraftOfTheTree)
{
    const auto aircraft = testsupport::lightSingle();
    EXPECT_NEAR(aircraft->wingAreaM2, 16.165, 1e-9);
    EXPECT_EQ(aircraft->contacts.size(), 8U);
    EXPECT_NEAR(aircraft->coefficient(simulation::Part::lift).table.at(0.0, 0.0), 0.25, 1e-12);
    EXPECT_NEAR(aircraft->coefficient(simulation::Part::dragAlpha).table.at(5.0, 20.0), 0.0881, 2e-4);
}

struct Fault
{
    const char* from;
    const char* to;
    const char* says;
};

class AircraftFaultTest : public testing::TestWithParam<Fault>
{
};

// Each fault is told with file, line, what and remedy in one line.
TEST_P(AircraftFaultTest, IsExplained)
{
    std::string text = wholeFile();
    const std::size_t at = text.find(GetParam().from);
    ASSERT_NE(at, std::string::npos) << GetParam().from;
    text.replace(at, std::string(GetParam().from).size(), GetParam().to);
    const auto aircraft = simulation::parseAircraft(text, "file.xml");
    ASSERT_FALSE(aircraft);
    const std::string message = aircraft.error().message();
    EXPECT_THAT(message, HasSubstr(GetParam().says));
    EXPECT_THAT(message, HasSubstr("file.xml:"));
    EXPECT_THAT(message, HasSubstr("; "));
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, AircraftFaultTest,
    testing::Values(Fault{"wingSpanM=", "wingSpan=", "unknown attribute 'wingSpan'"},
                    Fault{"wingSpanM=\"10.912\"", "", "has no wingSpanM"},
                    Fault{"wingSpanM=\"10.912\"", "wingSpanM=\"nan\"", "wingSpanM is 'nan'"},
                    Fault{"wingSpanM=\"10.912\"", "wingSpanM=\"-3\"", "wingSpanM is '-3'"},
                    Fault{"source=\"c172p\" wingArea", "source=\"nobody\" wingArea",
                          "'nobody' is not listed"},
                    Fault{"source=\"c172p\" wingArea", "wingArea", "names no source"},
                    Fault{"<geometry", "<geometri", "<geometri> is unknown"},
                    Fault{"version=\"1\"", "version=\"2\"", "version"},
                    Fault{"part=\"liftFlap\"", "part=\"liftFlop\"", "'liftFlop' is unknown"},
                    Fault{"part=\"liftFlap\"", "part=\"lift\"", "given twice"},
                    Fault{"part=\"pitchAlpha\"", "part=\"pitchFlap\"", "pitchFlap"},
                    Fault{"over=\"flapDeg\">", "over=\"flaps\">", "over is 'flaps'"},
                    Fault{"0.1952", "many", "has 'many'"}, Fault{"0.78 0.1952", "0.78", "has a row of 1"},
                    Fault{"0.78 0.1952", "0.6 0.1952", "do not rise"},
                    Fault{"rollYawKgM2=\"0\"", "rollYawKgM2=\"9000\"", "no body has this"},
                    Fault{"turnsRight=\"1\"", "turnsRight=\"0.5\"", "neither 1 nor -1"},
                    Fault{"brake=\"left\"", "brake=\"both\"", "brake is 'both'"},
                    Fault{"contentsKg=\"45.3592\"", "contentsKg=\"450\"", "contentsKg is '450'"},
                    Fault{"</aircraft>", "", "not well-formed"}));

TEST(AircraftFileTest, SaysWhenThereIsNoFile)
{
    const auto aircraft = simulation::readAircraft("/nowhere/a.xml");
    ASSERT_FALSE(aircraft);
    EXPECT_THAT(aircraft.error().message(), HasSubstr("no such file"));
}

} // namespace
