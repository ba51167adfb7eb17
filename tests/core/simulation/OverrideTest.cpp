// SPDX-License-Identifier: Apache-2.0
// Pedals and gears that actions take over: speeds worked by hand for a car of 5 m/s² and 10 m/s² (kCar).
#include <gtest/gtest.h>

#include "RoadPlay.h"

namespace simulation
{
namespace
{

std::string overridden(const std::string& controls)
{
    return "<PrivateAction><ControllerAction><OverrideControllerValueAction>" + controls +
           "</OverrideControllerValueAction></ControllerAction></PrivateAction>";
}

/// Ego drives at 20 m/s; its controls are taken over at 1 s, and perhaps changed at 3 s.
ScenarioText driving(const std::string& atOne, const std::string& atThree = "")
{
    ScenarioText text;
    text.privates = roadplay::onLane(100.0) + speedAction(20.0);
    std::string events = event("a", overridden(atOne), timeCondition(1.0));
    if (!atThree.empty()) events += event("b", atThree, timeCondition(3.0));
    text.stories = story(events);
    return text;
}

double speedAt(const ScenarioText& text, double timeS)
{
    return roadplay::played(text, timeS)->entities()[0].speedMps;
}

TEST(Override, ABrakeTakesItsShareOfTheGreatestDeceleration)
{
    const auto text = driving(R"(<Brake active="true" value="0.5"/>)");
    EXPECT_NEAR(speedAt(text, 3.0), 20.0 - 0.5 * 10.0 * 2.0, 1e-9);
    EXPECT_EQ(speedAt(text, 6.0), 0.0) << "after 4 s it stands, and does not roll back";
    EXPECT_NEAR(speedAt(driving(R"(<Brake active="true" value="0.25"/>)"), 3.0), 15.0, 1e-9);
}

TEST(Override, AThrottleTakesItsShareOfTheGreatestAcceleration)
{
    EXPECT_NEAR(speedAt(driving(R"(<Throttle active="true" value="0.6"/>)"), 3.0), 20.0 + 0.6 * 5.0 * 2.0,
                1e-9);
    EXPECT_NEAR(speedAt(driving(R"(<Throttle active="true" value="1"/>)"), 30.0), 70.0, 1e-9) << "maxSpeed";
    EXPECT_NEAR(
        speedAt(driving(R"(<Throttle active="true" value="0.6"/><Clutch active="true" value="0.5"/>)"), 3.0),
        20.0 + 0.5 * 0.6 * 5.0 * 2.0, 1e-9);
}

TEST(Override, GearsSayWhichWayTheThrottleWorks)
{
    const std::string throttle = R"(<Throttle active="true" value="1"/>)";
    EXPECT_NEAR(speedAt(driving(throttle + R"(<Gear active="true" number="0"/>)"), 3.0), 20.0, 1e-9);
    EXPECT_NEAR(speedAt(driving(throttle + R"(<Gear active="true"><ManualGear number="-1"/></Gear>)"), 6.0),
                -5.0, 1e-9)
        << "20 m/s less 5 m/s² in 5 s";
    EXPECT_EQ(speedAt(driving(throttle + R"(<Gear active="true"><AutomaticGear gear="p"/></Gear>)"), 3.1),
              0.0)
        << "10 m/s², 2 s";
}

TEST(Override, ABrakingForceSlowsAMass)
{
    // 1500 kg, where the file says nothing: 6000 N are 4 m/s².
    const auto text = driving(R"(<Brake active="true"><BrakeForce value="6000"/></Brake>)");
    EXPECT_NEAR(speedAt(text, 3.0), 12.0, 1e-9);
    EXPECT_NEAR(
        speedAt(driving(R"(<ParkingBrake active="true"><BrakePercent value="40"/></ParkingBrake>)"), 3.0),
        12.0, 1e-9);
}

TEST(Override, SpeedActionsWaitUntilThePedalsAreGivenBack)
{
    const std::string brake = R"(<Brake active="true" value="0.1"/>)",
                      off = R"(<Brake active="false" value="0"/>)";
    EXPECT_NEAR(speedAt(driving(brake, speedAction(30.0)), 5.0), 16.0, 1e-9) << "not heard";
    const auto text = driving(brake, overridden(off));
    EXPECT_NEAR(speedAt(text, 5.0), 18.0, 1e-9) << "the speed stays as it was at 3 s";
    ScenarioText again = text;
    again.stories = story(event("a", overridden(brake), timeCondition(1.0)) +
                          event("b", overridden(off), timeCondition(3.0)) +
                          event("c", speedAction(30.0), timeCondition(4.0)));
    EXPECT_NEAR(speedAt(again, 5.0), 30.0, 1e-9);
}

TEST(Override, AControllerIsThereAgainWhenThePedalsAreGivenBack)
{
    ScenarioText text =
        driving(R"(<Brake active="true" value="0.5"/>)", overridden(R"(<Brake active="false" value="0"/>)"));
    text.entities =
        R"(<ScenarioObject name="Ego">)" + kCar +
        R"(<ObjectController><Controller name="c"><Properties><Property name="esminiController" value="ACCController"/>
<Property name="mode" value="override"/><Property name="setSpeed" value="20"/></Properties></Controller></ObjectController></ScenarioObject>)";
    text.privates +=
        R"(<PrivateAction><ControllerAction><ActivateControllerAction longitudinal="true" lateral="false"/></ControllerAction></PrivateAction>)";
    EXPECT_NEAR(speedAt(text, 3.0), 10.0, 1e-6);
    EXPECT_NEAR(speedAt(text, 30.0), 20.0, 1e-3);
}

TEST(Override, TheSteeringWheelIsToldAsNotInEffect)
{
    const auto parsed = parseScenario(driving(R"(<SteeringWheel active="true" value="0.3"/>)").text(),
                                      "test.xosc", {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    ASSERT_EQ(parsed->problems.size(), 1u);
    EXPECT_NE(parsed->problems[0].error.message().find("SteeringWheel"), std::string::npos);
}

TEST(Override, ASlipperyRoadBoundsHowItBrakes)
{
    // Friction 0.3: 3 m/s² instead of 10 m/s².
    ScenarioText text = driving(R"(<Brake active="true" value="1"/>)");
    text.globals =
        R"(<GlobalAction><EnvironmentAction><Environment name="e"><RoadCondition frictionScaleFactor="0.3"/>
</Environment></EnvironmentAction></GlobalAction>)";
    EXPECT_NEAR(speedAt(text, 3.0), 20.0 - 2.0 * 0.3 * 10.0, 1e-9);
    text.globals.clear();
    EXPECT_NEAR(speedAt(text, 2.0), 10.0, 1e-9);
}

} // namespace
} // namespace simulation
