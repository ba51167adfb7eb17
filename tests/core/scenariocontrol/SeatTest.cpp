// SPDX-License-Identifier: Apache-2.0
// A person in an entity of a scenario: taking over, giving back, and what the storyboard measures.
#include <cmath>

#include "SeatPlay.h"

namespace
{

using namespace seatplay;
using simulation::event;
using simulation::speedAction;
using simulation::story;
using simulation::timeCondition;

const std::string kCoast = "osgtrainer-inputs 1\ncolumns time throttle gear\n0 0 4\n";
const std::string kFull = "osgtrainer-inputs 1\ncolumns time throttle gear\n0 1 4\n";
const std::string kBrake = "osgtrainer-inputs 1\ncolumns time throttle brake gear clutch\n0 0 0.6 1 1\n";

std::string ofEgo(const std::string& condition)
{
    return "<ConditionGroup><Condition name=\"c\" delay=\"0\" conditionEdge=\"none\"><ByEntityCondition>"
           "<TriggeringEntities triggeringEntitiesRule=\"any\"><EntityRef entityRef=\"Ego\"/>"
           "</TriggeringEntities><EntityCondition>" +
           condition + "</EntityCondition></ByEntityCondition></Condition></ConditionGroup>";
}

/// Ego at 20 m/s, and Other ahead of it at 15 m/s on the same lane; the story of Other begins where the
/// condition holds for Ego.
simulation::ScenarioText behindOther(const std::string& condition, double gapM = 60.0)
{
    simulation::ScenarioText text = moving(20.0);
    text.entities += "<ScenarioObject name=\"Other\">" + simulation::kCar + "</ScenarioObject>";
    text.globals = "<Private entityRef=\"Other\">" + onLane(105.0 + gapM) + speedAction(15.0) + "</Private>";
    text.stories = story(event("cutIn", speedAction(10.0), ofEgo(condition)));
    const std::string actors = "<EntityRef entityRef=\"Ego\"/></Actors>";
    text.stories.replace(text.stories.find(actors), actors.size(),
                         "<EntityRef entityRef=\"Other\"/></Actors>");
    return text;
}

const std::string kHeadway =
    "<TimeHeadwayCondition entityRef=\"Other\" value=\"1.5\" freespace=\"true\" coordinateSystem=\"road\" "
    "relativeDistanceType=\"longitudinal\" rule=\"lessThan\"/>";

double freeGapM(const SeatedPlay& play)
{
    return play.player->entities()[1].position.x - play.player->entities()[0].position.x - 5.0;
}

TEST(Seat, FromTheStartAPersonHasTheEntityWithPhysicsOfItsOwn)
{
    const InputsFile inputs("seat_full", kFull);
    const SeatedPlay play = byInputs(moving(20.0), inputs.path());
    ASSERT_TRUE(play.player);
    EXPECT_EQ(play.player->told()[0].drivenBy, "person");
    play.playTo(5.0);
    EXPECT_TRUE(play.ego().wheelTurnDeg);
    EXPECT_GT(play.ego().speedMps, 24.0);
    EXPECT_NEAR(play.ego().odometerM, play.ego().position.x - 100.0, 1.0);
    ASSERT_TRUE(play.ego().laneUnder);
    EXPECT_EQ(play.ego().laneUnder->lane, -1);
    // The control: nobody sits there.
    const SeatedPlay alone = seated(moving(20.0), {});
    alone.playTo(5.0);
    EXPECT_EQ(alone.player->told()[0].drivenBy, "scenario");
    EXPECT_DOUBLE_EQ(alone.ego().speedMps, 20.0);
}

/// The headway is that of the person: it comes where the person comes near, and never where one stays behind.
TEST(Seat, ATriggerMeasuresThePerson)
{
    const InputsFile full("seat_near", kFull), brake("seat_behind", kBrake);
    const SeatedPlay near = byInputs(behindOther(kHeadway), full.path());
    while (near.player->timeS() < 30.0 && !near.hasBegun("cutIn"))
    {
        if (near.player->timeS() > 0.1)
        {
            EXPECT_GT(freeGapM(near) / near.ego().speedMps, 1.5 - 0.02);
        }
        near.player->step();
    }
    ASSERT_TRUE(near.hasBegun("cutIn"));
    EXPECT_NEAR(freeGapM(near) / near.ego().speedMps, 1.5, 0.02);
    // The scenario alone, at 20 m/s, meets it later: (60 - 30) / 5 = 6 s.
    EXPECT_LT(near.player->timeS(), 5.5);
    const SeatedPlay alone = seated(behindOther(kHeadway), {});
    alone.playTo(5.9);
    EXPECT_FALSE(alone.hasBegun("cutIn"));
    alone.playTo(6.1);
    EXPECT_TRUE(alone.hasBegun("cutIn"));
    const SeatedPlay behind = byInputs(behindOther(kHeadway), brake.path());
    behind.playTo(30.0);
    EXPECT_FALSE(behind.hasBegun("cutIn"));
    EXPECT_NEAR(behind.ego().speedMps, 0.0, 0.1);
}

TEST(Seat, SpeedDistanceAndPlaceAreThePersons)
{
    const InputsFile full("seat_kinds", kFull);
    const std::string place = "<ReachPositionCondition tolerance=\"2\"><Position><LanePosition roadId=\"1\" "
                              "laneId=\"-1\" s=\"220\"/></Position></ReachPositionCondition>";
    for (const std::string& condition :
         {std::string("<SpeedCondition value=\"23\" rule=\"greaterThan\"/>"),
          std::string("<TraveledDistanceCondition value=\"120\"/>"), place,
          std::string("<RelativeDistanceCondition entityRef=\"Other\" relativeDistanceType=\"longitudinal\" "
                      "value=\"40\" freespace=\"true\" rule=\"lessThan\"/>")})
    {
        const SeatedPlay play = byInputs(behindOther(condition), full.path());
        while (play.player->timeS() < 20.0 && !play.hasBegun("cutIn"))
            play.player->step();
        ASSERT_TRUE(play.hasBegun("cutIn")) << condition;
        if (condition.find("SpeedC") != std::string::npos)
            EXPECT_NEAR(play.ego().speedMps, 23.0, 0.1);
        else if (condition.find("Travel") != std::string::npos)
            EXPECT_NEAR(play.ego().position.x, 220.0, 0.5);
        else if (condition.find("Reach") != std::string::npos)
            EXPECT_NEAR(play.ego().position.x, 218.0, 0.5);
        else
            EXPECT_NEAR(freeGapM(play), 40.0, 0.2);
    }
}

/// Taken over and given back at odd steps, with keys that are held: the recording repeats to the last bit.
TEST(Seat, WhatAPersonDidRepeatsBitForBit)
{
    const auto text = behindOther(kHeadway, 400.0);
    const SeatedPlay first = seated(text, {.entity = "", .isRecorded = true});
    std::vector<glm::dvec3> places;
    std::vector<std::string> drivers;
    for (int step = 0; step < 1500; ++step)
    {
        if (step == 137 || step == 1011 || step == 700)
        {
            EXPECT_EQ(first.seat->giveToPerson(step != 700), "");
        }
        if (auto* const controls = first.seat->controls())
        {
            simulation::ManualController& hands = controls->manual();
            hands.hold(static_cast<std::size_t>(hands.axisOf("throttle")), step % 200 < 90 ? 1.0 : 0.0);
            hands.hold(static_cast<std::size_t>(hands.axisOf("steering")), step % 90 < 9    ? 0.1
                                                                           : step % 90 < 18 ? -0.1
                                                                                            : 0.0);
        }
        first.player->step();
        places.push_back(first.ego().position);
        drivers.push_back(first.player->told()[0].drivenBy);
    }
    EXPECT_EQ(std::count(drivers.begin(), drivers.end(), "person"), 700 - 137 + 1500 - 1011);
    const double endS = first.player->timeS();
    const InputsFile recorded("seat_recorded", simulation::writeInputs(first.seat->recorded(endS)));
    const SeatedPlay again = seated(text, {.entity = "", .inputs = recorded.path(), .isRecorded = true});
    for (std::size_t step = 0; step < places.size(); ++step)
    {
        EXPECT_FALSE(again.player->areMotionsDone());
        again.player->step();
        ASSERT_EQ(again.ego().position, places[step]) << "step " << step;
        ASSERT_EQ(again.player->told()[0].drivenBy, drivers[step]) << "step " << step;
    }
    EXPECT_TRUE(again.player->areMotionsDone()) << "the inputs have ended";
    EXPECT_EQ(simulation::writeInputs(again.seat->recorded(endS)),
              simulation::writeInputs(first.seat->recorded(endS)));
    // The control: given back a step later it is another drive.
    std::string later = simulation::writeInputs(first.seat->recorded(endS));
    later.replace(later.find("\n700 0"), 6, "\n701 0");
    const InputsFile other("seat_other", later);
    const SeatedPlay different = seated(text, {.entity = "", .inputs = other.path()});
    different.playTo(endS);
    EXPECT_NE(different.ego().position, places.back());
}

/// Beside its lane, askew and slow: it comes back to the middle of its lane and to the speed of the scenario,
/// and no step is a jump.
TEST(Seat, GivenBackItGoesOnAlongItsLaneAtTheSpeedThatIsAskedFor)
{
    const InputsFile inputs("seat_back",
                            "osgtrainer-inputs 1\ncolumns time person steering brake gear clutch\n"
                            "0 1 0 0 4 0\n1 1 0.02 0.4 4 1\n2 1 0 0 4 1\n3 0 0 0 4 0\n");
    const SeatedPlay play = seated(moving(20.0), {.entity = "", .inputs = inputs.path()});
    play.playTo(3.0);
    const double left = play.ego().position.y, slow = play.ego().speedMps;
    EXPECT_GT(left, -1.75 + 0.2);
    EXPECT_LT(slow, 18.5);
    glm::dvec3 before = play.ego().position;
    double headingDeg = play.ego().headingDeg;
    while (play.player->timeS() < 12.0)
    {
        play.player->step();
        EXPECT_LT(glm::distance(play.ego().position, before), 25.0 / 120.0 + 0.02) << play.player->timeS();
        EXPECT_LT(std::abs(play.ego().headingDeg - headingDeg), 0.5) << play.player->timeS();
        before = play.ego().position;
        headingDeg = play.ego().headingDeg;
    }
    EXPECT_EQ(play.player->told()[0].drivenBy, "scenario");
    EXPECT_NEAR(play.ego().position.y, -1.75, 1e-6);
    EXPECT_NEAR(play.ego().headingDeg, 0.0, 1e-6);
    EXPECT_DOUBLE_EQ(play.ego().speedMps, 20.0);
    EXPECT_TRUE(play.tells("the person gives it back"));
    EXPECT_TRUE(play.tells("goes on from"));
}

/// A controller with physics that the person took the entity from has it again.
TEST(Seat, GivenBackADriverGoesOn)
{
    const InputsFile inputs("seat_driver", "osgtrainer-inputs 1\ncolumns time person throttle gear\n"
                                           "0 0 0 4\n2 1 1 4\n4 0 0 4\n");
    const SeatedPlay play = seated(driven(20.0), {.entity = "", .inputs = inputs.path()});
    play.playTo(1.0);
    EXPECT_EQ(play.player->told()[0].drivenBy, "Driver");
    play.playTo(3.0);
    EXPECT_EQ(play.player->told()[0].drivenBy, "person");
    play.playTo(4.1);
    EXPECT_EQ(play.player->told()[0].drivenBy, "Driver");
    play.playTo(20.0);
    EXPECT_NEAR(play.ego().position.y, -1.75, 0.1);
}

/// On a trajectory it goes on along the rest of it, as much later as it is late.
TEST(Seat, GivenBackItGoesOnAlongTheRestOfItsTrajectory)
{
    simulation::ScenarioText text;
    const auto at = [](double x)
    {
        return simulation::vertex("<WorldPosition x=\"" + std::to_string(x) + "\" y=\"-1.75\" h=\"0\"/>",
                                  std::to_string(x / 20.0));
    };
    text.privates = onLane(1.0) + speedAction(20.0) +
                    simulation::followTrajectory(at(1.0) + at(500.0) + at(2000.0), simulation::kTiming);
    const InputsFile inputs("seat_way", "osgtrainer-inputs 1\ncolumns time person brake gear clutch\n"
                                        "0 0 0 1 1\n5 1 1 1 1\n15 0 0 1 1\n");
    const SeatedPlay play = seated(text, {.entity = "", .inputs = inputs.path()});
    play.playTo(15.0);
    const double stoodAtM = play.ego().position.x;
    EXPECT_NEAR(play.ego().speedMps, 0.0, 0.2);
    EXPECT_LT(stoodAtM, 200.0);
    play.playTo(25.0);
    EXPECT_NEAR(play.ego().position.x, stoodAtM + 200.0, 2.0);
}

std::string manual(const std::string& kind)
{
    return "<ScenarioObject name=\"Ego\">" + simulation::kCar + controller(kind, "") + "</ScenarioObject>";
}

TEST(Seat, AManualControllerHandsTheEntityOverInTheStoryboard)
{
    for (const char* kind : {"InteractiveController", "interactiveDriver", "ExternalController", "Manual"})
    {
        simulation::ScenarioText text = moving(20.0);
        text.entities = manual(kind);
        text.stories = story(event("take", activate("true", "true"), timeCondition(2.0)) +
                             event("back", activate("false", "false"), timeCondition(6.0)));
        const InputsFile inputs("seat_manual", kCoast);
        const SeatedPlay play = seated(text, {.entity = "", .inputs = inputs.path()});
        play.playTo(1.9);
        EXPECT_EQ(play.player->told()[0].drivenBy, "scenario") << kind;
        play.playTo(3.0);
        EXPECT_EQ(play.player->told()[0].drivenBy, "person") << kind;
        EXPECT_LT(play.ego().speedMps, 20.0);
        play.playTo(6.1);
        EXPECT_EQ(play.player->told()[0].drivenBy, "scenario") << kind;
        EXPECT_EQ(*simulation::manualEntity(play.player->scenario()), 0U);
    }
}

/// Without anybody it is told; esmini's interactive driver stands, the scenario moves any other.
TEST(Seat, AManualControllerWithoutAPersonIsTold)
{
    for (const bool isInteractive : {true, false})
    {
        simulation::ScenarioText text = moving(20.0);
        text.entities = manual(isInteractive ? "InteractiveController" : "ExternalController");
        text.stories = story(event("take", activate("true", "true"), timeCondition(2.0)));
        const auto player = played(text, 4.0);
        ASSERT_TRUE(player);
        EXPECT_DOUBLE_EQ(ego(*player).speedMps, isInteractive ? 0.0 : 20.0);
        ASSERT_EQ(player->notes().size(), 1U);
        EXPECT_NE(player->notes()[0].find("nobody sits there"), std::string::npos) << player->notes()[0];
    }
}

/// The person runs into the car ahead: an impact with its name, once, and the collision that conditions see.
TEST(Seat, AnotherEntityIsMet)
{
    simulation::ScenarioText text =
        behindOther("<CollisionCondition><EntityRef entityRef=\"Other\"/></CollisionCondition>", 30.0);
    text.globals.replace(text.globals.find("15.0"), 4, "5.00");
    const InputsFile inputs("seat_hit", kCoast);
    const SeatedPlay play = byInputs(text, inputs.path());
    double deepestM = -1.0;
    bool hasBlow = false;
    while (play.player->timeS() < 8.0)
    {
        play.player->step();
        deepestM = std::max(deepestM, -freeGapM(play));
        if (const auto& blow = play.player->told()[0].blow)
        {
            EXPECT_FALSE(hasBlow) << "one impact";
            hasBlow = true;
            EXPECT_EQ(blow->with, "Other");
            // The bumper gives over two short steps; the harder of them counts.
            EXPECT_NEAR(blow->speedMps - 5.0, blow->closingMps, 5.0);
            EXPECT_NEAR(blow->courseRad, 0.0, 0.05);
        }
    }
    EXPECT_TRUE(hasBlow);
    EXPECT_TRUE(play.hasBegun("cutIn")) << "CollisionCondition";
    // The box of the scenario's car and the hull of the data file differ by some decimetres.
    EXPECT_LT(deepestM, 0.6);
    EXPECT_LT(play.ego().speedMps, 8.0);
    EXPECT_TRUE(play.tells("into a vehicle (Other)"));
}

TEST(Seat, ItSaysWhoCanBeDriven)
{
    auto parsed = simulation::parseScenario(behindOther(kHeadway).text(), "test.xosc",
                                            {.tolerant = true, .parameters = {}});
    ASSERT_TRUE(parsed);
    const auto none = simulation::seatIn(parsed->scenario, "Egoo");
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().message().find("write one of: Ego, Other"), std::string::npos)
        << none.error().message();
    const InputsFile wrong("seat_wrong", "osgtrainer-inputs 1\ncolumns time elevator\n0 0\n");
    const auto seat = simulation::PersonSeat::create({.entity = "Ego", .inputs = wrong.path()},
                                                     parsed->scenario.entities[0], {nullptr, std::nullopt});
    ASSERT_FALSE(seat);
    EXPECT_NE(seat.error().message().find("no input 'elevator'"), std::string::npos);
    const auto plane = simulation::PersonSeat::create({.entity = "Ego", .vehicle = kAircraftFile},
                                                      parsed->scenario.entities[0], {nullptr, std::nullopt});
    ASSERT_FALSE(plane);
    EXPECT_NE(plane.error().message().find("is an aircraft"), std::string::npos);
}

} // namespace
