// SPDX-License-Identifier: Apache-2.0
// Mistakes in controllers with physics: one line each, with file, line and remedy; and what is done when one
// cannot begin later.
#include "../reference/MarkdownTable.h"
#include "ControlPlay.h"
#include "simulation/control/scenario/VehicleControllers.h"
#include "simulation/scenario/ControllerKinds.h"

namespace
{

using namespace controlplay;

struct Mistake
{
    const char* name;
    simulation::ScenarioText text;
    const char* message;
};

class ControllerMistakes : public testing::TestWithParam<Mistake>
{
};

TEST_P(ControllerMistakes, AreToldInOneLine)
{
    const auto player = opened(GetParam().text);
    ASSERT_FALSE(player);
    const std::string message = player.error().message();
    EXPECT_NE(message.find("test.xosc:"), std::string::npos) << message;
    EXPECT_NE(message.find(GetParam().message), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos);
}

simulation::ScenarioText withVehicle(const std::string& file)
{
    simulation::ScenarioText text = driven(20.0);
    text.entities = "<ScenarioObject name=\"Ego\">" + simulation::kCar +
                    controller("Driver", property("vehicle", file)) + "</ScenarioObject>";
    return text;
}

INSTANTIATE_TEST_SUITE_P(
    All, ControllerMistakes,
    testing::Values(
        Mistake{"UnknownProperty", driven(20.0, property("sped", "3")), "write one of: vehicle, seed"},
        Mistake{"NoNumber", driven(20.0, property("speed", "fast")),
                "property speed: is 'fast'; write a number from 0.1 to 100"},
        Mistake{"OutOfRange", driven(20.0, property("headway", "99")), "write a number from 0.1 to 10"},
        Mistake{"NoFlag", driven(20.0, property("overtakes", "1")), "write true or false"},
        Mistake{"NoFile", withVehicle("nothing.xml"), "no such file"},
        Mistake{"NoVehicle", withVehicle("data/scenarios/drive.xosc"), "is no data file of a vehicle"},
        Mistake{"AircraftWithDriver", withVehicle(kAircraftFile), "a Driver drives road vehicles alone"},
        Mistake{"NoInputs", driven(20.0, "", "RecordedInputs"), "property inputs: is missing"},
        Mistake{"MissingInputs", driven(20.0, property("inputs", "no.txt"), "RecordedInputs"), "no.txt"},
        Mistake{"NoOrder", flown(50.0, property("orders", "loop")), "'loop' is no order"},
        Mistake{"NoStrip", flown(50.0, property("orders", "land")), "give the property strip"},
        Mistake{"ShortStrip", flown(50.0, property("strip", "0,0,90")),
                "write 4 to 5 numbers parted by commas"},
        Mistake{"AutopilotInCar", driven(20.0, "", "Autopilot"), "the data file of an aircraft"}),
    [](const auto& test) { return std::string(test.param.name); });

/// Water from 500 m east on.
class Shore final : public simulation::Ground
{
public:
    void below(std::span<const glm::dvec3> points, std::span<simulation::GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {0.0,
                          {0.0, 0.0, 1.0},
                          points[i].x > 500.0 ? simulation::GroundKind::water
                                              : simulation::GroundKind::asphalt,
                          true};
    }
};

TEST(ControllerStarts, InWaterAreAnErrorAtTheBeginAndANoteLater)
{
    Stage stage;
    stage.ground = std::make_shared<Shore>();
    simulation::ScenarioText text = driven(20.0);
    text.privates = onLane(600.0) + simulation::speedAction(20.0) + activate("true", "true");
    const auto atOnce = opened(text, stage);
    ASSERT_FALSE(atOnce);
    EXPECT_NE(atOnce.error().message().find("lies in water; move it onto land"), std::string::npos)
        << atOnce.error().message();

    text.privates = onLane(600.0) + simulation::speedAction(20.0);
    text.stories = simulation::story(
        simulation::event("later", activate("true", "true"), simulation::timeCondition(2.0)));
    const auto player = played(text, 10.0, stage);
    ASSERT_TRUE(player);
    // Road entities stand for a step after their teleport alone; the scenario moves it on.
    EXPECT_NEAR(ego(*player).position.x, 600.0 + 20.0 * 10.0, 0.5);
    ASSERT_EQ(player->notes().size(), 1U);
    EXPECT_NE(player->notes()[0].find("lies in water"), std::string::npos) << player->notes()[0];
    EXPECT_NE(player->notes()[0].find("the scenario moves it"), std::string::npos) << player->notes()[0];
}

TEST(ControllerStarts, ACarThatDrivesIntoWaterIsTold)
{
    Stage stage;
    stage.ground = std::make_shared<Shore>();
    const auto player = played(driven(30.0), 25.0, stage);
    ASSERT_TRUE(player);
    ASSERT_EQ(player->notes().size(), 1U);
    EXPECT_NE(player->notes()[0].find("Ego crashed after"), std::string::npos) << player->notes()[0];
    EXPECT_NE(player->notes()[0].find("water"), std::string::npos) << player->notes()[0];
}

/// The kinds with physics, and those that have a maker.
reference::Names kindsWithPhysics()
{
    reference::Names names;
    for (const simulation::ControllerKind& kind : simulation::controllerKinds())
        if (kind.role == simulation::ControllerRole::vehicle) names.insert(std::string(kind.name));
    return names;
}

reference::Names makersWithPhysics(std::size_t leftOut = 0)
{
    reference::Names names;
    for (const auto& maker : std::span(simulation::kVehicleControllers).subspan(leftOut))
        names.insert(std::string(maker().name));
    return names;
}

TEST(ControllersWithPhysics, EachHasAKindAndAMaker)
{
    EXPECT_EQ(reference::differences(kindsWithPhysics(), makersWithPhysics()), "");
    EXPECT_NE(reference::differences(kindsWithPhysics(), makersWithPhysics(1)), "");
}

TEST(ControllersWithPhysics, HaveTheirPropertiesOnThePage)
{
    reference::Names known{"kind"};
    for (const std::string_view property : simulation::kVehicleProperties)
        known.insert(std::string(property));
    for (const auto& maker : simulation::kVehicleControllers)
        for (const std::string_view property : maker().properties)
            known.insert(std::string(property));
    const auto page = reference::Page::read("openscenario.md");
    EXPECT_EQ(reference::differences(known, page.column("Controllers with physics", 0)), "");
    EXPECT_NE(reference::differences(known, page.without("inputs").column("Controllers with physics", 0)),
              "");
}

} // namespace
