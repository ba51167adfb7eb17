// SPDX-License-Identifier: Apache-2.0
// `trainer play` with pictures where a scenario names roads and no terrain: they are drawn in the frame of
// its positions.
#include <osgOffscreen/PngFile>

#include "Playing.h"

namespace
{

/// 200 m along x, far from the origin, one lane of 4 m on each side.
const char* const kRoad =
    R"(<OpenDRIVE><header revMajor="1" revMinor="7"/><road id="1" length="200" junction="-1">
<planView><geometry s="0" x="31000" y="-17000" hdg="0" length="200"><line/></geometry></planView>
<lanes><laneSection s="0"><left><lane id="1" type="driving" level="false"><width sOffset="0" a="4" b="0" c="0" d="0"/></lane></left>
<center><lane id="0" type="none" level="false"/></center>
<right><lane id="-1" type="driving" level="false"><width sOffset="0" a="4" b="0" c="0" d="0"/></lane></right></laneSection></lanes></road></OpenDRIVE>)";

std::string carAt(const std::string& position)
{
    return R"(<OpenSCENARIO><FileHeader revMajor="1" revMinor="2" date="2026-06-01T12:00:00" author="test" description="road"/>
<RoadNetwork><LogicFile filepath="road.xodr"/><SceneGraphFile filepath="gone.osgb"/></RoadNetwork>
<Entities><ScenarioObject name="car"><Vehicle name="car" vehicleCategory="car">
<BoundingBox><Center x="1.4" y="0" z="0.7"/><Dimensions width="1.8" length="4.5" height="1.4"/></BoundingBox>
<Performance maxSpeed="50" maxAcceleration="5" maxDeceleration="9"/>
<Axles><FrontAxle maxSteering="0.5" wheelDiameter="0.6" trackWidth="1.6" positionX="2.7" positionZ="0.3"/>
<RearAxle maxSteering="0" wheelDiameter="0.6" trackWidth="1.6" positionX="0" positionZ="0.3"/></Axles></Vehicle></ScenarioObject></Entities>
<Storyboard><Init><Actions><Private entityRef="car"><PrivateAction><TeleportAction><Position>)" +
           position +
           R"(</Position></TeleportAction></PrivateAction></Private></Actions></Init><StopTrigger/></Storyboard></OpenSCENARIO>)";
}

/// By how many levels the ground before the car is greener than red.
int greenBefore(const Workplace& place, const std::string& name, const std::string& position)
{
    place.write("road.xodr", kRoad);
    const std::string scenario = place.write(name + ".xosc", carAt(position)), folder = place.path(name);
    const ProgramRun run = runTrainer({"play", scenario, "--frames", "1", "--size", "64x36", "--eye",
                                       "driver", "--interior", "off", "--capture", folder});
    EXPECT_TRUE(succeeds(run));
    EXPECT_NE(run.output.find("gone.osgb is not there"), std::string::npos) << run.output;
    const auto picture = osgOffscreen::readPng(folder + "/frame_00000.png");
    if (!picture) return 0;
    const unsigned char* pixel = (*picture)->data(32, 4); // rows count from below
    return pixel[1] - pixel[0];
}

TEST(RoadPlay, ShowsTheRoadsOfAScenarioWhereItsPositionsAre)
{
    const Workplace place;
    EXPECT_LT(greenBefore(place, "on", R"(<LanePosition roadId="1" laneId="-1" s="50"/>)"), 5);
    EXPECT_LT(greenBefore(place, "there", R"(<WorldPosition x="31050" y="-17002"/>)"), 5);
    EXPECT_GT(greenBefore(place, "beside", R"(<WorldPosition x="31050" y="-17060"/>)"), 8);
}

/// CARLA 2940: a lane without a width is drawn 0 m wide; it was, without a word in all three.
TEST(RoadPlay, TellsWhatIsWrongWithTheRoads)
{
    const Workplace place;
    const std::string width = R"(<width sOffset="0" a="4" b="0" c="0" d="0"/>)",
                      told = "road 1: lane 1 of the section at s 0 has neither width nor border";
    const std::string scenario =
        place.write("wrong.xosc", carAt(R"(<LanePosition roadId="1" laneId="-1" s="50"/>)"));
    const auto says = [&](const std::vector<std::string>& words)
    {
        const ProgramRun run = runTrainer(words);
        EXPECT_TRUE(succeeds(run)) << run.text();
        return run.text().find(told) != std::string::npos;
    };
    for (const bool isWrong : {true, false})
    {
        place.write("road.xodr", isWrong ? with(kRoad, width, "") : kRoad);
        EXPECT_EQ(says({"play", scenario, "--frames", "1", "--size", "64x36"}), isWrong);
        EXPECT_EQ(says({"play", scenario, "--headless", "--duration", "1"}), isWrong);
        EXPECT_EQ(says({"check", scenario}), isWrong);
    }
}

/// Nothing of it is played: roads at a path were meant to be there. (It was played on level ground once, for
/// 3 600 s, and a slip in the path looked like success.)
TEST(RoadPlay, RefusesRoadsThatAreNotThere)
{
    const Workplace place;
    const std::string scenario = place.write("gone.xosc", carAt(R"(<WorldPosition x="40" y="-7" z="12"/>)"));
    const auto before = place.files();
    const std::vector<std::string> words{"gone.xosc:2: the LogicFile road.xodr is not there",
                                         "correct its path", "--without-roads"};
    EXPECT_TRUE(
        failsWith(runTrainer({"play", scenario, "--headless", "--duration", "1"}), 1, "trainer", words));
    EXPECT_TRUE(failsWith(runTrainer({"play", scenario, "--frames", "1", "--size", "64x36", "--capture",
                                      place.path("pictures")}),
                          1, "trainer", words));
    const ProgramRun checked = runTrainer({"check", scenario});
    EXPECT_EQ(checked.exitCode, 1);
    EXPECT_NE(checked.output.find("gone.xosc:2: the LogicFile road.xodr is not there"), std::string::npos)
        << checked.text();
    EXPECT_NE(checked.output.find("gone.xosc:2: the SceneGraphFile gone.osgb is not there"),
              std::string::npos)
        << checked.text();
    EXPECT_EQ(place.files(), before);
    // The controls: who says so plays without them, and roads that are there are played.
    const ProgramRun without =
        runTrainer({"play", scenario, "--headless", "--duration", "1", "--without-roads"});
    EXPECT_TRUE(succeeds(without)) << without.text();
    EXPECT_NE(without.errors.find("warning: " + scenario + ":2: the LogicFile road.xodr is not there"),
              std::string::npos)
        << without.text();
    place.write("road.xodr", kRoad);
    EXPECT_TRUE(succeeds(runTrainer({"play", scenario, "--headless", "--duration", "1"})));
}

TEST(RoadPlay, LaysLevelGroundWhereTheTownIsNotThere)
{
    const Workplace place;
    const std::string there = with(carAt(R"(<WorldPosition x="40" y="-7" z="12"/>)"), "road.xodr", "Town01");
    const std::size_t begin = there.find("<RoadNetwork>") + 13;
    const std::string nowhere = there.substr(0, begin) + there.substr(there.find("</RoadNetwork>"));
    struct Case
    {
        const char *eye, *note;
        std::string text;
    };
    for (const auto& [eye, note, text] :
         {Case{"above", "there are no roads", there},
          Case{"chase", "there are no roads",
               carAt(R"(<WorldPosition x="487000" y="5432000" z="120"/>)")}, // as a map's coordinates are
          Case{"driver", "RoadNetwork names neither SceneGraphFile nor LogicFile", nowhere}})
    {
        const std::string folder = place.path(eye), scenario = place.write(std::string(eye) + ".xosc", text);
        const ProgramRun run = runTrainer({"play", scenario, "--frames", "1", "--size", "64x36", "--eye", eye,
                                           "--interior", "off", "--capture", folder, "--without-roads"});
        EXPECT_TRUE(succeeds(run));
        EXPECT_NE(run.output.find(std::string(note) + "; entities move over level ground"), std::string::npos)
            << run.output;
        const auto picture = osgOffscreen::readPng(folder + "/frame_00000.png");
        ASSERT_TRUE(picture);
        const unsigned char* pixel = (*picture)->data(4, 4);
        EXPECT_GT(pixel[1], pixel[2] + 8) << "no ground from " << eye;
    }
}

} // namespace
