// SPDX-License-Identifier: Apache-2.0
#include "simulation/parser/ParseScenario.h"

#include <filesystem>
#include <fstream>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include "ScenarioText.h"

namespace simulation
{
namespace
{

Scenario parsed(const std::string& text)
{
    const auto result = parseScenario(text, "test.xosc");
    EXPECT_TRUE(result) << result.error().message();
    return result ? result->scenario : Scenario{};
}

template<class T>
T firstAction(const Scenario& scenario)
{
    return std::get<T>(scenario.storyboard.init.privates.at(0).actions.at(0));
}

TEST(ParseScenario, HeaderAndRoadNetwork)
{
    const Scenario scenario = parsed(
        R"(<OpenSCENARIO><FileHeader revMajor="1" revMinor="0" date="2024-01-01T00:00:00" description="x" author="y"/>
<RoadNetwork><LogicFile filepath="a.xodr"/><SceneGraphFile filepath="b.roam"/></RoadNetwork><Entities/>
<Storyboard><Init><Actions/></Init><StopTrigger/></Storyboard></OpenSCENARIO>)");
    EXPECT_EQ(scenario.header.revMinor, 0);
    EXPECT_EQ(scenario.header.author, "y");
    EXPECT_EQ(scenario.roadNetwork.logicFile, "a.xodr");
    EXPECT_EQ(scenario.roadNetwork.sceneGraphFile, "b.roam");
    EXPECT_TRUE(scenario.storyboard.stopTrigger);
    EXPECT_TRUE(scenario.isConsistent());
}

TEST(ParseScenario, VehicleKeepsBoxAxlesAndLine)
{
    const Scenario scenario = parsed(ScenarioText{}.text());
    const auto& vehicle = std::get<Vehicle>(scenario.entities.at(0).object);
    EXPECT_EQ(vehicle.category, "car");
    EXPECT_EQ(vehicle.box.lengthM, 5.0);
    EXPECT_EQ(vehicle.box.centre, glm::dvec3(1.4, 0.0, 0.75));
    EXPECT_EQ(vehicle.frontAxle->positionXM, 3.0);
    EXPECT_EQ(vehicle.source.line, 5);
    EXPECT_FALSE(scenario.entities.at(0).isAirborne());
}

TEST(ParseScenario, PedestrianAndMiscObjectAndPropertiesAndAir)
{
    const std::string box =
        R"(<BoundingBox><Center x="0" y="0" z="1"/><Dimensions width="1" length="2" height="3"/></BoundingBox>)";
    ScenarioText text;
    text.entities =
        R"(<ScenarioObject name="p"><Pedestrian name="p" pedestrianCategory="pedestrian" mass="80">)" + box +
        R"(<Properties><Property name="k" value="v"/><File filepath="f.osgb"/></Properties></Pedestrian></ScenarioObject>
<ScenarioObject name="m"><MiscObject name="m" miscObjectCategory="none" mass="1">)" +
        box +
        R"(<Properties><Property name="domain" value="air"/></Properties></MiscObject></ScenarioObject>)";
    const Scenario scenario = parsed(text.text());
    EXPECT_EQ(scenario.entities.at(0).properties().find("k"), "v");
    EXPECT_EQ(scenario.entities.at(0).properties().files.at(0), "f.osgb");
    EXPECT_FALSE(scenario.entities.at(0).isAirborne());
    EXPECT_TRUE(scenario.entities.at(1).isAirborne());
    EXPECT_EQ(scenario.entityIndex("m"), 1);
    EXPECT_EQ(scenario.entityIndex("x"), -1);
}

TEST(ParseScenario, PositionsInEveryForm)
{
    ScenarioText text;
    text.privates = teleport(R"(<WorldPosition x="1" y="-2.5" z="3" h="0.1" p="0.2" r="0.3"/>)");
    const auto world = std::get<WorldPosition>(firstAction<TeleportAction>(parsed(text.text())).position);
    EXPECT_EQ(world.yM, -2.5);
    EXPECT_EQ(world.zM, 3.0);
    EXPECT_EQ(world.orientation.rollRad, 0.3);
    text.privates = teleport(R"(<GeoPosition latitudeDeg="46.5" longitudeDeg="8" altitude="100"/>)");
    const auto modern = std::get<GeoPosition>(firstAction<TeleportAction>(parsed(text.text())).position);
    EXPECT_EQ(modern.latitudeDeg, 46.5);
    EXPECT_EQ(modern.altitudeM, 100.0);
    EXPECT_FALSE(modern.heightM);
    text.privates = teleport(
        R"(<GeoPosition latitude="0.8" longitude="-0.1" height="5"><Orientation h="1" type="absolute"/></GeoPosition>)");
    const auto old = std::get<GeoPosition>(firstAction<TeleportAction>(parsed(text.text())).position);
    EXPECT_DOUBLE_EQ(old.latitudeDeg, foundation::degreesOf(0.8));
    EXPECT_EQ(old.heightM, 5.0);
    EXPECT_EQ(old.orientation.headingRad, 1.0);
}

TEST(ParseScenario, TrajectoryInTheOldAndTheNewForm)
{
    ScenarioText text;
    const std::string vertices =
        vertex(R"(<WorldPosition x="0" y="0"/>)", "0") + vertex(R"(<WorldPosition x="9" y="0"/>)", "3");
    text.privates = followTrajectory(
        vertices, R"(<Timing domainAbsoluteRelative="absolute" scale="2" offset="1"/>)", "follow", "true");
    const auto action = firstAction<FollowTrajectoryAction>(parsed(text.text()));
    EXPECT_EQ(action.timing->domain, Timing::Domain::absolute);
    EXPECT_EQ(action.timing->scale, 2.0);
    EXPECT_EQ(action.mode, FollowingMode::follow);
    EXPECT_TRUE(action.trajectory.closed);
    EXPECT_EQ(std::get<Polyline>(action.trajectory.shape).vertices.at(1).timeS, 3.0);
    std::string old = text.text();
    old.replace(old.find("<TrajectoryRef>"), 15, "");
    old.replace(old.find("</TrajectoryRef>"), 16, "");
    EXPECT_EQ(firstAction<FollowTrajectoryAction>(parsed(old)), action);
}

TEST(ParseScenario, SpeedActionInEveryShapeAndDimension)
{
    for (const char* shape : {"step", "linear", "cubic", "sinusoidal"})
        for (const char* dimension : {"time", "distance", "rate"})
        {
            ScenarioText text;
            text.privates = speedAction(12.0, shape, dimension, 3.0);
            const auto action = firstAction<SpeedAction>(parsed(text.text()));
            EXPECT_EQ(std::get<AbsoluteTargetSpeed>(action.target).speedMps, 12.0);
            EXPECT_EQ(action.dynamics.value, 3.0);
        }
}

TEST(ParseScenario, EnvironmentWithAllItsParts)
{
    ScenarioText text;
    text.globals = R"(<GlobalAction><EnvironmentAction><Environment name="e">
<TimeOfDay animation="true" dateTime="2025-06-13T06:00:00Z"/>
<Weather cloudState="free"><Sun azimuth="1" elevation="0.5" intensity="1"/><Fog visualRange="500"/>
<Precipitation precipitationType="rain" intensity="0.5"/><Wind direction="1" speed="2"/></Weather>
<RoadCondition frictionScaleFactor="0.9"/></Environment></EnvironmentAction></GlobalAction>)";
    const auto action = std::get<EnvironmentAction>(parsed(text.text()).storyboard.init.globals.at(0));
    EXPECT_TRUE(action.environment.timeOfDay->animation);
    EXPECT_EQ(action.environment.weather->fogVisualRangeM, 500.0);
    EXPECT_EQ(action.environment.weather->sun->elevationRad, 0.5);
    EXPECT_EQ(action.environment.weather->precipitation->intensity, 10.0); // mm/h: half of the most
    EXPECT_EQ(action.environment.weather->cloudState, "free");
    EXPECT_EQ(action.environment.roadFriction, 0.9);
}

TEST(ParseScenario, StoryboardDownToConditions)
{
    ScenarioText text;
    text.stories =
        story(event("a", speedAction(1.0), timeCondition(2.0, "greaterThan", "rising", 0.5), "overwrite", 3) +
              event("b", speedAction(2.0),
                    R"(<ConditionGroup><Condition name="c" delay="0" conditionEdge="none"><ByValueCondition>
<StoryboardElementStateCondition storyboardElementType="event" storyboardElementRef="a" state="endTransition"/>
</ByValueCondition></Condition></ConditionGroup>)",
                    "override"));
    text.stop = stopAt(9.0);
    const Scenario scenario = parsed(text.text());
    const Maneuver& maneuver = scenario.storyboard.stories.at(0).acts.at(0).groups.at(0).maneuvers.at(0);
    const Event& first = maneuver.events.at(0);
    EXPECT_EQ(first.maximumExecutionCount, 3);
    EXPECT_EQ(first.priority, Priority::overwrite);
    EXPECT_EQ(maneuver.events.at(1).priority, Priority::overwrite);
    const Condition& condition = first.startTrigger->groups.at(0).conditions.at(0);
    EXPECT_EQ(condition.edge, ConditionEdge::rising);
    EXPECT_EQ(condition.delayS, 0.5);
    EXPECT_EQ(std::get<SimulationTimeCondition>(condition.content).seconds, 2.0);
    const Condition& second = maneuver.events.at(1).startTrigger->groups.at(0).conditions.at(0);
    EXPECT_EQ(std::get<StoryboardElementStateCondition>(second.content).element, "a");
}

TEST(ParseScenario, ParametersArePutInAndCanBeReplaced)
{
    ScenarioText text;
    text.declarations =
        R"(<ParameterDeclarations><ParameterDeclaration name="kmh" parameterType="double" value="36"/>
<ParameterDeclaration name="speed" parameterType="double" value="${$kmh / 3.6}"/>
<ParameterDeclaration name="who" parameterType="string" value="Ego"/></ParameterDeclarations>)";
    text.privates =
        R"(<PrivateAction><LongitudinalAction><SpeedAction><SpeedActionDynamics dynamicsShape="step"
dynamicsDimension="time" value="0"/><SpeedActionTarget><AbsoluteTargetSpeed value="$speed"/></SpeedActionTarget></SpeedAction></LongitudinalAction></PrivateAction>)";
    std::string source = text.text();
    source.replace(source.find("entityRef=\"Ego\""), 15, "entityRef=\"$who\"");
    const auto speedOf = [](const Scenario& scenario)
    { return std::get<AbsoluteTargetSpeed>(firstAction<SpeedAction>(scenario).target).speedMps; };
    EXPECT_DOUBLE_EQ(speedOf(parsed(source)), 10.0);
    const auto replaced = parseScenario(source, "x", {.tolerant = false, .parameters = {{"kmh", "72"}}});
    ASSERT_TRUE(replaced);
    EXPECT_DOUBLE_EQ(speedOf(replaced->scenario), 20.0);
    EXPECT_FALSE(parseScenario(source, "x", {.tolerant = false, .parameters = {{"mph", "72"}}}));
}

TEST(ParseScenario, CatalogueEntriesAreReadWithTheirAssignments)
{
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "catalogue_test";
    std::filesystem::create_directories(folder / "cat");
    std::ofstream(folder / "cat" / "Vehicles.xosc")
        << R"(<OpenSCENARIO><FileHeader revMajor="1" revMinor="3" date="d" description="d" author="a"/><Catalog name="Cars">)"
        << R"(<Vehicle name="small" vehicleCategory="car"><ParameterDeclarations><ParameterDeclaration name="length" parameterType="double" value="3"/></ParameterDeclarations>
<BoundingBox><Center x="0" y="0" z="0"/><Dimensions width="2" length="$length" height="1"/></BoundingBox>
<Performance maxSpeed="1" maxDeceleration="1" maxAcceleration="1"/>
<Axles><RearAxle maxSteering="0" wheelDiameter="1" trackWidth="1" positionX="0" positionZ="0"/></Axles></Vehicle></Catalog></OpenSCENARIO>)";
    ScenarioText text;
    text.catalogs =
        R"(<CatalogLocations><VehicleCatalog><Directory path="./cat"/></VehicleCatalog></CatalogLocations>)";
    text.entities =
        R"(<ScenarioObject name="Ego"><CatalogReference catalogName="Cars" entryName="small"><ParameterAssignments>
<ParameterAssignment parameterRef="length" value="4.5"/></ParameterAssignments></CatalogReference></ScenarioObject>)";
    std::ofstream(folder / "test.xosc") << text.text();
    const auto result = readScenario(folder / "test.xosc");
    ASSERT_TRUE(result) << result.error().message();
    EXPECT_EQ(result->scenario.entities.at(0).box().lengthM, 4.5);
    std::string wrong = text.text();
    wrong.replace(wrong.find("small"), 5, "large");
    std::ofstream(folder / "wrong.xosc") << wrong;
    const auto missing = readScenario(folder / "wrong.xosc");
    ASSERT_FALSE(missing);
    EXPECT_NE(missing.error().what.find("Cars/large"), std::string::npos);
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace simulation
