// SPDX-License-Identifier: Apache-2.0
#include "simulation/writer/WriteScenario.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "ScenarioText.h"
#include "SimulatedTrack.h"
#include "simulation/parser/ParseScenario.h"

namespace simulation
{
namespace
{

Scenario everything()
{
    ScenarioText text;
    text.declarations = "<ParameterDeclarations><ParameterDeclaration name=\"p\" parameterType=\"double\" "
                        "value=\"0.1\"/></ParameterDeclarations>";
    text.globals =
        R"(<GlobalAction><EnvironmentAction><Environment name="e &amp; &lt;f>"><TimeOfDay animation="true" dateTime="2025-06-13T06:00:00.5+02:00"/>
<Weather fractionalCloudCover="twoOktas" temperature="280"><Sun azimuth="1" elevation="0.5" illuminance="1"/><Fog visualRange="500"/>
<Precipitation precipitationType="rain" precipitationIntensity="0.5"/><Wind direction="1" speed="2"/></Weather><RoadCondition frictionScaleFactor="0.9"><Properties><Property name="ground" value="snow 4.1; cleared"/></Properties></RoadCondition></Environment></EnvironmentAction></GlobalAction>)";
    text.privates =
        teleport("<WorldPosition x=\"0.1\" y=\"1e-17\" z=\"3\" h=\"0.5\"/>") +
        followTrajectory(
            vertex("<GeoPosition latitudeDeg=\"46.123456789012345\" longitudeDeg=\"8\" height=\"5\"/>", "0") +
                vertex("<GeoPosition latitude=\"0.8\" longitude=\"0.1\" altitude=\"7\"><Orientation "
                       "h=\"1\"/></GeoPosition>",
                       "2.5"),
            kTiming, "follow", "true");
    text.stories = story(event("a", speedAction(1.0, "cubic", "rate", 2.0),
                               timeCondition(2.0, "greaterThan", "rising", 0.5), "overwrite", 2) +
                         event("b", speedAction(2.0), timeCondition(3.0), "skip"));
    text.stop = stopAt(9.0);
    const auto parsed = parseScenario(text.text(), "test.xosc");
    EXPECT_TRUE(parsed) << parsed.error().message();
    return parsed->scenario;
}

TEST(WriteScenario, ReadsBackToAnEqualModel)
{
    const Scenario scenario = everything();
    const auto text = scenarioText(scenario);
    ASSERT_TRUE(text);
    const auto again = parseScenario(*text, "again.xosc");
    ASSERT_TRUE(again) << again.error().message();
    EXPECT_EQ(again->scenario, scenario);
    Scenario changed = again->scenario;
    auto& follow = std::get<FollowTrajectoryAction>(changed.storyboard.init.privates.at(0).actions.at(1));
    std::get<GeoPosition>(std::get<Polyline>(follow.trajectory.shape).vertices.at(0).position).latitudeDeg +=
        1e-14;
    EXPECT_NE(changed, scenario) << "the comparison notices the last digit";
}

TEST(WriteScenario, RealScenarioSurvives)
{
    if (!realData()) GTEST_SKIP() << "OSGTRAINER_REAL_DATA is unset: no real data, nothing was tested";
    const auto parsed = readScenario(*realData() / "openscenario/esmini/xosc/lane-change_trajectory_wp.xosc");
    ASSERT_TRUE(parsed);
    const auto text = scenarioText(parsed->scenario);
    ASSERT_TRUE(text);
    Scenario expected = parsed->scenario;
    expected.header.revMinor = 3;
    EXPECT_EQ(parseScenario(*text, "again")->scenario, expected);
}

TEST(WriteScenario, RefusesWhatItDoesNotKnow)
{
    Scenario scenario = everything();
    scenario.storyboard.init.privates.at(0).actions.push_back(Unsupported{{}, "LaneChangeAction"});
    const auto refused = scenarioText(scenario);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().what.find("LaneChangeAction"), std::string::npos);
}

} // namespace
} // namespace simulation
