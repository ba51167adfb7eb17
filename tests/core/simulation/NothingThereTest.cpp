// SPDX-License-Identifier: Apache-2.0
// References to what is not there, and places on earth over roads that know where they lie.
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "simulation/road/ScenarioRoads.h"
#include "simulation/scenario/NamedFile.h"

namespace simulation
{
namespace
{

std::string afterElement(const std::string& name)
{
    return "<ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\"><ByValueCondition>"
           "<StoryboardElementStateCondition storyboardElementType=\"event\" storyboardElementRef=\"" +
           name + "\" state=\"completeState\"/></ByValueCondition></Condition></ConditionGroup>";
}

TEST(NothingThere, AConditionOnNoElementIsNeverTrueAndTold)
{
    ScenarioText text;
    text.privates = roadplay::onLane(10.0) + speedAction(10.0);
    text.stories = story(event("a", speedAction(5.0), afterElement("nobody")) +
                         event("b", speedAction(20.0), timeCondition(1.0)));
    const auto player = roadplay::played(text, 3.0);
    ASSERT_TRUE(player);
    EXPECT_NEAR(player->entities()[0].speedMps, 20.0, 1e-9);
    ASSERT_EQ(player->warnings().size(), 1u);
    EXPECT_NE(player->warnings()[0].message().find(
                  "the storyboard element nobody does not exist; instead: the condition is never true"),
              std::string::npos)
        << player->warnings()[0].message();
    text.stories = story(event("a", speedAction(5.0), timeCondition(0.5)) +
                         event("b", speedAction(20.0), afterElement("a")));
    EXPECT_TRUE(roadplay::played(text, 3.0)->warnings().empty()) << "of what is there";
}

TEST(NothingThere, AnEntityThatBeginsOnNoRoadOrLaneIsRefused)
{
    for (const auto& [place, said] :
         {std::pair(roadplay::onLane(10.0, -1, "77"), "the road 77 does not exist"),
          std::pair(roadplay::onLane(10.0, -9), "has no lane -9")})
    {
        ScenarioText text;
        text.privates = place + speedAction(10.0);
        const auto player = roadplay::created(text);
        ASSERT_FALSE(player) << said;
        EXPECT_NE(player.error().message().find(said), std::string::npos) << player.error().message();
    }
}

/// What is told of a story of one event; nothing where it does not say `said` once.
std::string toldOnce(const std::string& action, const std::string& condition = timeCondition(1.0))
{
    ScenarioText text;
    text.privates = roadplay::onLane(100.0) + speedAction(10.0);
    text.stories = story(event("a", action, condition));
    const auto player = roadplay::played(text, 2.0);
    if (!player || player->warnings().size() != 1) return {};
    EXPECT_NEAR(player->entities()[0].position.x, 120.0, 0.3) << "it drives on";
    return player->warnings()[0].message();
}

TEST(NothingThere, WhatIsToBeDoneOnARoadThatIsNotThereIsTold)
{
    const auto place = [](const char* road, const char* lane)
    { return std::string("<LanePosition roadId=\"") + road + "\" laneId=\"" + lane + "\" s=\"150\"/>"; };
    const auto change = [](const char* lane)
    {
        return std::string(
                   "<PrivateAction><LateralAction><LaneChangeAction><LaneChangeActionDynamics "
                   "dynamicsShape=\"linear\" value=\"2\" dynamicsDimension=\"time\"/><LaneChangeTarget>"
                   "<AbsoluteTargetLane value=\"") +
               lane + "\"/></LaneChangeTarget></LaneChangeAction></LateralAction></PrivateAction>";
    };
    const auto followed = [&](const std::string& last)
    { return followTrajectory(vertex(place("1", "-1"), "0") + vertex(last, "2"), kTiming); };
    const auto together = [&](const std::string& target)
    {
        return "<PrivateAction><SynchronizeAction masterEntityRef=\"Ego\"><TargetPositionMaster>" + target +
               "</TargetPositionMaster><TargetPosition>" + place("1", "-1") +
               "</TargetPosition></SynchronizeAction></PrivateAction>";
    };
    const auto near = [&](const std::string& target)
    {
        return "<ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\"><ByEntityCondition>"
               "<TriggeringEntities triggeringEntitiesRule=\"any\"><EntityRef entityRef=\"Ego\"/>"
               "</TriggeringEntities><EntityCondition><DistanceCondition value=\"5\" freespace=\"false\" "
               "rule=\"lessThan\"><Position>" +
               target + "</Position></DistanceCondition></EntityCondition></ByEntityCondition></Condition>" +
               "</ConditionGroup>";
    };
    const auto red = std::string("<ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\">"
                                 "<ByValueCondition><TrafficSignalCondition name=\"lamp\" state=\"red\"/>"
                                 "</ByValueCondition></Condition></ConditionGroup>");
    for (const auto& [told, said] :
         {std::pair(toldOnce(change("-9")), "no road has a lane -9; instead: nothing is done"),
          std::pair(toldOnce(followed(place("77", "-1"))),
                    "the road 77 does not exist; instead: the trajectory"),
          std::pair(toldOnce(followed(place("1", "-9"))), "the road 1 has no lane -9"),
          std::pair(toldOnce(together(place("77", "-1"))), "the road 77 does not exist; instead: nothing"),
          std::pair(toldOnce(speedAction(20.0), near(place("77", "-1"))), "the condition is never true"),
          std::pair(toldOnce(speedAction(20.0), red),
                    "sets the traffic signal lamp; instead: the condition")})
        EXPECT_NE(told.find(said), std::string::npos) << said << ": " << told;
    // The control: what is there.
    for (const std::string& action : {change("1"), followed(place("1", "-1")), together(place("1", "-1"))})
        EXPECT_EQ(toldOnce(action), "") << action;
    EXPECT_EQ(toldOnce(speedAction(10.0), near(place("1", "-1"))), "");
}

TEST(NothingThere, AnEntityThatIsSentToNoRoadOrLaneLaterStaysAndIsTold)
{
    for (const auto& [place, said] :
         {std::pair(roadplay::onLane(10.0, -1, "77"), "the road 77 does not exist"),
          std::pair(roadplay::onLane(10.0, -9), "has no lane -9")})
    {
        ScenarioText text;
        text.privates = roadplay::onLane(100.0) + speedAction(10.0);
        text.stories = story(event("a", place, timeCondition(1.0)));
        const auto player = roadplay::played(text, 2.0);
        ASSERT_TRUE(player);
        ASSERT_EQ(player->warnings().size(), 1u) << said;
        EXPECT_NE(player->warnings()[0].message().find(said), std::string::npos)
            << player->warnings()[0].message();
        EXPECT_NEAR(player->entities()[0].position.x, 120.0, 0.3) << "it drives on";
    }
}

/// CARLA 2940: a lane without a width is there, 0 m wide; who plays a scenario on it is told.
TEST(NothingThere, TheMistakesOfTheRoadsAreTold)
{
    const auto file = std::filesystem::temp_directory_path() / "osgtrainer-roads-with-mistakes.xodr";
    const auto mistakesOf = [&](const std::string& lanes)
    {
        std::ofstream(file) << roadtexts::network(
            roadtexts::road("1", 100.0, roadtexts::straightPlan(100.0) + lanes));
        const auto roads = RoadScene::open(file);
        EXPECT_TRUE(roads) << roads.error().message();
        return roads ? (*roads)->mistakes() : std::vector<foundation::Error>();
    };
    EXPECT_TRUE(mistakesOf(roadtexts::twoLanes()).empty());
    std::string wrong = roadtexts::twoLanes();
    const std::size_t width = wrong.find("<width");
    wrong.erase(width, wrong.find("/>", width) + 2 - width);
    const auto mistakes = mistakesOf(wrong);
    ASSERT_EQ(mistakes.size(), 1u);
    EXPECT_NE(mistakes[0].message().find("road 1: lane 1 of the section at s 0 has neither width nor border"),
              std::string::npos)
        << mistakes[0].message();
    std::filesystem::remove(file);
}

TEST(NothingThere, AChangeOfLaneWithoutRoadsIsLeftOutAndTold)
{
    ScenarioText text;
    text.privates = teleport("<WorldPosition x=\"10\" y=\"2\"/>") + speedAction(10.0);
    text.stories = story(
        event(
            "a",
            "<PrivateAction><LateralAction><LaneChangeAction><LaneChangeActionDynamics "
            "dynamicsShape=\"linear\" "
            "dynamicsDimension=\"time\" value=\"2\"/><LaneChangeTarget><RelativeTargetLane entityRef=\"Ego\" "
            "value=\"1\"/></LaneChangeTarget></LaneChangeAction></LateralAction></PrivateAction>",
            timeCondition(0.5)) +
        event("b", speedAction(20.0), afterElement("a")));
    const auto player = roadplay::played(text, 2.0, nullptr);
    ASSERT_TRUE(player);
    EXPECT_NEAR(player->entities()[0].position.y, 2.0, 1e-9);
    EXPECT_NEAR(player->entities()[0].speedMps, 20.0, 1e-9) << "the action has ended";
    ASSERT_EQ(player->warnings().size(), 1u);
    EXPECT_NE(player->warnings()[0].message().find("there are no roads; instead: nothing is done"),
              std::string::npos);
}

/// A transverse Mercator projection whose middle is 48° north, 11° east: north of it counts the arc of the
/// meridian.
std::shared_ptr<const RoadScene> georeferenced()
{
    const double length = 3000.0;
    std::string text = roadtexts::network(
        roadtexts::road("1", length, roadtexts::straightPlan(length) + roadtexts::twoLanes()));
    const std::string header = "<header revMajor=\"1\" revMinor=\"7\"/>";
    text.replace(
        text.find(header), header.size(),
        "<header revMajor=\"1\" revMinor=\"7\"><geoReference><![CDATA[+proj=tmerc +lat_0=48 +lon_0=11 +k=1 "
        "+x_0=0 +y_0=0 +datum=WGS84 +units=m]]></geoReference></header>");
    return std::make_shared<const RoadScene>(roadtexts::sound(text));
}

foundation::Result<std::unique_ptr<ScenarioPlayer>> onEarth(const std::shared_ptr<const RoadScene>& roads,
                                                            double latitudeDeg, double longitudeDeg)
{
    ScenarioText text;
    text.privates = teleport("<GeoPosition latitudeDeg=\"" + std::to_string(latitudeDeg) +
                             "\" longitudeDeg=\"" + std::to_string(longitudeDeg) + "\"/>");
    text.stop = stopAt(1.0);
    auto parsed = parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    PlayerOptions options;
    options.clock = FixedClock::forStep(roadplay::kStepS);
    options.roads = roads;
    options.projection = projectionOf(*roads);
    return ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
}

TEST(NothingThere, AGeoPositionIsWhereTheRoadsSay)
{
    auto player = onEarth(georeferenced(), 48.0001, 11.001);
    ASSERT_TRUE(player) << player.error().message();
    roadplay::playTo(**player, 0.1);
    const double a = 6378137.0, e2 = 0.00669437999014, sine = std::sin(48.0 * M_PI / 180.0);
    const double w = 1.0 - e2 * sine * sine, degree = M_PI / 180.0;
    const auto& place = (*player)->entities()[0].position;
    EXPECT_NEAR(place.x, 0.001 * degree * a / std::sqrt(w) * std::cos(48.0001 * degree), 0.01);
    EXPECT_NEAR(place.y, 0.0001 * degree * a * (1.0 - e2) / std::pow(w, 1.5), 0.01);
    EXPECT_FALSE(onEarth(roadplay::straight(), 48.0001, 11.001)) << "these roads do not know where they lie";
}

/// Traffic has usual cars where the catalogue of its vehicles is not there.
TEST(NothingThere, TrafficOfNoCatalogueIsDefaultCars)
{
    ScenarioText text;
    text.catalogs = "<RoadNetwork><LogicFile filepath=\"a.xodr\"/></RoadNetwork>"; // the first one counts
    text.privates = roadplay::onLane(500.0);
    text.globals =
        "<GlobalAction><TrafficAction trafficName=\"t\"><TrafficSourceAction rate=\"1\" radius=\"5\" "
        "speed=\"10\"><Position><LanePosition roadId=\"1\" laneId=\"-1\" s=\"50\"/></Position>"
        "<TrafficDistribution><TrafficDistributionEntry weight=\"1\"><EntityDistribution>"
        "<EntityDistributionEntry weight=\"1\"><ScenarioObjectTemplate><CatalogReference catalogName=\"c\" "
        "entryName=\"e\"/></ScenarioObjectTemplate></EntityDistributionEntry></EntityDistribution>"
        "</TrafficDistributionEntry></TrafficDistribution></TrafficSourceAction></TrafficAction></"
        "GlobalAction>";
    const auto parsed = parseScenario(text.text(), "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_EQ(parsed->problems[0].kind, Problem::Kind::assumed);
    EXPECT_NE(parsed->problems[0].error.remedy.find("a usual car is taken"), std::string::npos);
    const auto player = roadplay::played(text, 1.0);
    ASSERT_GT(player->entities().size(), 1u);
    EXPECT_NEAR(player->entities()[1].speedMps, 10.0, 0.5) << "it drives";
}

TEST(NothingThere, FilesAreFoundBesideTheScenarioToo)
{
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(testing::TempDir()) / "named";
    fs::create_directories(folder / "roads");
    std::ofstream(folder / "roads" / "a.xodr") << "a";
    std::ofstream(folder / "b.xodr") << "b";
    EXPECT_EQ(namedFile(folder, "roads/a.xodr"), folder / "roads/a.xodr");
    EXPECT_EQ(namedFile(folder, "roads\\a.xodr"), folder / "roads/a.xodr") << "as on Windows";
    EXPECT_EQ(namedFile(folder, "../elsewhere/b.xodr"), folder / "b.xodr") << "its last part, in the folder";
    EXPECT_EQ(namedFile(folder, "c.xodr"), folder / "c.xodr") << "nowhere";
    fs::remove_all(folder);
}

} // namespace
} // namespace simulation
