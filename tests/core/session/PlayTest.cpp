// SPDX-License-Identifier: Apache-2.0
// Scenarios that a host steps and drives in, without graphics.
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <osgSession/core/Play.h>

#include "../roads/RoadTexts.h"
#include "../simulation/ScenarioText.h"
#include "TestFolder.h"

namespace
{

using osgSession::core::Entity;
using osgSession::core::Event;
using osgSession::core::Play;
using osgSession::core::PlaySettings;

const std::filesystem::path kCarFile = OSGTRAINER_SOURCE_DIR "/data/vehicles/car.xml";
const std::filesystem::path kAircraftFile = OSGTRAINER_SOURCE_DIR "/data/aircraft/c172p.xml";

/// A car at the begin of a straight road of 3 km, and an event at 1 s.
class SteppedPlay : public testing::Test
{
protected:
    SteppedPlay()
    {
        constexpr double kLengthM = 3000.0;
        _folder.write("road.xodr",
                      roadtexts::network(roadtexts::road(
                          "1", kLengthM, roadtexts::straightPlan(kLengthM) + roadtexts::twoLanes())));
        simulation::ScenarioText text;
        text.privates = simulation::teleport(R"(<LanePosition roadId="1" laneId="-1" s="50"/>)");
        text.stories = simulation::story(
            simulation::event("faster", simulation::speedAction(5.0), simulation::timeCondition(1.0)));
        text.stop = simulation::stopAt(30.0);
        std::string written = text.text();
        const std::string none = "<RoadNetwork/>";
        written.replace(written.find(none), none.size(),
                        R"(<RoadNetwork><LogicFile filepath="road.xodr"/></RoadNetwork>)");
        _scenario = _folder.write("one.xosc", written);
    }

    PlaySettings settings(bool isDriven = false) const
    {
        PlaySettings settings{.scenario = _scenario};
        if (isDriven) settings.driven["Ego"] = kCarFile;
        return settings;
    }

    std::unique_ptr<Play> opened(const PlaySettings& settings) const
    {
        auto play = Play::open(settings);
        EXPECT_TRUE(play) << (play ? "" : play.error().message());
        return play ? std::move(*play) : nullptr;
    }

    std::string errorOf(const PlaySettings& settings) const
    {
        const auto play = Play::open(settings);
        return play ? "none" : play.error().message();
    }

    static void stepTo(Play& play, double timeS)
    {
        while (play.timeS() < timeS - 1e-9)
            ASSERT_TRUE(play.step()) << "it ends at " << play.timeS() << " s";
    }

    static Entity ego(const Play& play) { return *play.entity("Ego"); }

    testsupport::TestFolder _folder{"stepped-play"};
    std::filesystem::path _scenario;
};

TEST_F(SteppedPlay, MovesEntitiesAndTellsEventsOnce)
{
    const auto play = opened(settings());
    ASSERT_TRUE(play);
    EXPECT_EQ(play->stepS(), 1.0 / 120.0);
    EXPECT_NEAR(ego(*play).position.x, 50.0, 1e-9);
    EXPECT_NEAR(ego(*play).position.y, -1.75, 1e-9);
    stepTo(*play, 3.0);
    EXPECT_NEAR(ego(*play).speedMps, 5.0, 1e-9);
    EXPECT_NEAR(ego(*play).position.x, 60.0, 0.1);
    std::vector<double> startsS;
    for (const Event& event : play->takeEvents())
        if (event.element.ends_with("faster") && event.transition == "startTransition")
            startsS.push_back(event.timeS);
    ASSERT_EQ(startsS.size(), 1U);
    EXPECT_NEAR(startsS.front(), 1.0, 0.02);
    EXPECT_TRUE(play->takeEvents().empty());
    stepTo(*play, 30.0);
    EXPECT_TRUE(play->isFinished());
    EXPECT_FALSE(play->step());
}

TEST_F(SteppedPlay, DrivesACarByItsInputs)
{
    const auto play = opened(settings(true));
    ASSERT_TRUE(play);
    ASSERT_TRUE(play->set("Ego", "throttle", 0.5));
    stepTo(*play, 6.0);
    const double fastMps = ego(*play).speedMps;
    EXPECT_GT(fastMps, 5.0); // not the scenario's speed: the car's own physics
    EXPECT_NEAR(ego(*play).position.y, -1.75, 0.2);
    ASSERT_TRUE(play->set("Ego", "steering", 0.3));
    stepTo(*play, 7.0);
    EXPECT_GT(ego(*play).headingDeg, 2.0); // to the left
    ASSERT_TRUE(play->set("Ego", "throttle", 0.0));
    ASSERT_TRUE(play->set("Ego", "brake", 1.0));
    stepTo(*play, 12.0);
    EXPECT_NEAR(ego(*play).speedMps, 0.0, 0.05);
}

TEST_F(SteppedPlay, FliesAnAircraftByItsInputs)
{
    simulation::ScenarioText text;
    text.privates = simulation::teleport(R"(<WorldPosition x="0" y="0" z="1000" h="0"/>)") +
                    simulation::speedAction(50.0);
    text.stop = simulation::stopAt(30.0);
    text.entities =
        R"(<ScenarioObject name="Ego"><MiscObject name="aircraft" miscObjectCategory="none" mass="1100">
<BoundingBox><Center x="0" y="0" z="1.4"/><Dimensions width="11" length="8.1" height="2.75"/></BoundingBox>
<Properties><Property name="domain" value="air"/></Properties></MiscObject></ScenarioObject>)";
    PlaySettings settings{.scenario = _folder.write("air.xosc", text.text()),
                          .driven = {{"Ego", kAircraftFile}}};
    const auto play = opened(settings);
    ASSERT_TRUE(play);
    ASSERT_TRUE(play->set("Ego", "aileron", 0.3)) << testing::PrintToString(play->inputs("Ego"));
    stepTo(*play, 2.0);
    EXPECT_GT(std::abs(ego(*play).rollDeg), 5.0);
}

TEST_F(SteppedPlay, NamesWhatItHasWhereAnInputIsWrong)
{
    const auto play = opened(settings(true));
    ASSERT_TRUE(play);
    const auto unknown = play->set("Ego", "stearing", 0.1);
    ASSERT_FALSE(unknown);
    EXPECT_NE(unknown.error().message().find("steering"), std::string::npos) << unknown.error().message();
    EXPECT_FALSE(play->set("Other", "throttle", 0.1));
    EXPECT_FALSE(play->set("Ego", "throttle", std::numeric_limits<double>::quiet_NaN()));
    EXPECT_FALSE(play->entity("Other"));
    EXPECT_TRUE(opened(settings())->inputs("Ego").empty());
}

TEST_F(SteppedPlay, LivesBesideAnotherInOneProcess)
{
    const auto alone = opened(settings(true));
    ASSERT_TRUE(alone && alone->set("Ego", "throttle", 0.7));
    stepTo(*alone, 4.0);
    const auto first = opened(settings(true));
    const auto second = opened(settings());
    ASSERT_TRUE(first && second && first->set("Ego", "throttle", 0.7));
    while (first->timeS() < 4.0 - 1e-9)
        ASSERT_TRUE(first->step() && second->step());
    EXPECT_EQ(ego(*first).position, ego(*alone).position);
    EXPECT_EQ(ego(*first).speedMps, ego(*alone).speedMps);
    EXPECT_NE(ego(*first).position, ego(*second).position);
}

TEST_F(SteppedPlay, TellsWhatCannotBeOpened)
{
    PlaySettings wrong = settings(true);
    wrong.driven["Nobody"] = kCarFile;
    EXPECT_NE(errorOf(wrong).find("Nobody"), std::string::npos) << errorOf(wrong);
    wrong = settings();
    wrong.driven["Ego"] = _folder / "none.xml";
    EXPECT_NE(errorOf(wrong).find("none.xml"), std::string::npos) << errorOf(wrong);
    wrong = settings();
    wrong.scenario = _folder / "none.xosc";
    EXPECT_NE(errorOf(wrong).find("none.xosc"), std::string::npos) << errorOf(wrong);
    wrong.scenario = _folder.write("torn.xosc", "<OpenSCENARIO><Storyboard>");
    EXPECT_NE(errorOf(wrong).find("torn.xosc"), std::string::npos) << errorOf(wrong);
    for (const int steps : {0, -5, 1'000'000})
    {
        wrong = settings();
        wrong.stepsPerSecond = steps;
        EXPECT_NE(errorOf(wrong).find("stepsPerSecond"), std::string::npos) << errorOf(wrong);
    }
}

} // namespace
