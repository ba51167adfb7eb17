// SPDX-License-Identifier: Apache-2.0
// `trainer tour` over a road network: a drive, a flight, and what is wrong with asking for either.
#include "Playing.h"

namespace
{

/// 80 m along x with one lane of 4 m on each side.
std::string shortRoad(const std::string& traffic, const std::string& laneType = "driving")
{
    const std::string lane =
        "type=\"" + laneType + R"(" level="false"><width sOffset="0" a="4" b="0" c="0" d="0"/></lane>)";
    return R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="80" junction="-1" rule=")" +
           traffic +
           R"("><planView><geometry s="0" x="0" y="0" hdg="0" length="80"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" )" +
           lane + R"(</left><center><lane id="0" type="none" level="false"/></center><right><lane id="-1" )" +
           lane + "</right></laneSection></lanes></road></OpenDRIVE>";
}

/// What `trainer tour` over a network says and saves.
struct Toured
{
    ProgramRun run;
    std::string scenario;
};
Toured toured(const Workplace& place, const std::string& network, const std::string& eye)
{
    const std::string saved = place.path("tour.xosc");
    Toured tour{runTrainer({"tour", place.write("road.xodr", network), "--eye", eye, "--save", saved,
                            "--frames", "1", "--size", "64x36", "--capture", place.path("frames")}),
                ""};
    if (tour.run.exitCode == 0) tour.scenario = readBytes(saved);
    return tour;
}

std::size_t countOf(const std::string& text, const std::string& word)
{
    std::size_t count = 0;
    for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        ++count;
    return count;
}

TEST(RoadTour, IsADriveOnTheSideOfTheTraffic)
{
    const Workplace place;
    const Toured right = toured(place, shortRoad("RHT"), "own"),
                 left = toured(place, shortRoad("LHT"), "driver");
    EXPECT_TRUE(succeeds(right.run));
    EXPECT_NE(right.run.output.find("drive: 80 m of lanes from road 1"), std::string::npos)
        << right.run.output;
    EXPECT_NE(right.scenario.find("name=\"car\""), std::string::npos);
    // 75 m at 13.9 m/s and the braking: a vertex each half second.
    EXPECT_GT(countOf(right.scenario, "<Vertex "), 15u);
    EXPECT_LT(countOf(right.scenario, "<Vertex "), 25u);
    EXPECT_TRUE(succeeds(left.run));
    EXPECT_NE(left.scenario, right.scenario);
}

TEST(RoadTour, IsAFlightForAPilot)
{
    const Workplace place;
    const Toured flight = toured(place, shortRoad("RHT"), "pilot");
    EXPECT_TRUE(succeeds(flight.run));
    EXPECT_NE(flight.run.output.find("m above the ground"), std::string::npos) << flight.run.output;
    EXPECT_EQ(flight.scenario.find("name=\"car\""), std::string::npos);
}

TEST(RoadTour, WithoutARoadOrALaneForCarsIsRefused)
{
    const Workplace place;
    EXPECT_TRUE(failsWith(toured(place, shortRoad("RHT", "sidewalk"), "above").run, 1, "trainer",
                          {"road.xodr", "no lane for cars", "--eye pilot"}));
    EXPECT_TRUE(failsWith(runTrainer({"tour", place.hill(), "--eye", "driver"}), 1, "trainer",
                          {"hill.tif", "no roads to drive along", "--eye pilot"}));
}

} // namespace
