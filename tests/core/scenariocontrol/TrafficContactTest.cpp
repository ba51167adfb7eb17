// SPDX-License-Identifier: Apache-2.0
// A person's car meets traffic that keeps the rules, on a straight road: how it is told, and what the others
// do.
#include <algorithm>
#include <array>
#include <cmath>

#include <foundation/Angle.h>

#include "ControlPlay.h"
#include "simulation/control/VehicleMotion.h"
#include "simulation/vehicle/WeatherAir.h"
#include "simulation/vehicle/road/RoadVehicle.h"
#include "simulation/vehicle/road/RoadVehicleFile.h"

namespace
{

using namespace controlplay;
using simulation::BoundingBox;
using simulation::EntityState;
using simulation::RoadInput;

constexpr double kMostDepthM = 0.05;

/// A box in the plan.
struct PlanBox
{
    glm::dvec2 middle{0.0}, along{1.0, 0.0}, halfM{0.0};
};

PlanBox planOf(const EntityState& state, const glm::dvec3& middle, const glm::dvec2& sizeM)
{
    const double heading = foundation::radiansOf(state.headingDeg);
    const glm::dvec2 along(std::cos(heading), std::sin(heading)), left(-along.y, along.x);
    return {glm::dvec2(state.position) + middle.x * along + middle.y * left, along, 0.5 * sizeM};
}

/// How deep one box lies in another: the shortest way out. Negative: they are apart.
double depthOf(const PlanBox& a, const PlanBox& b)
{
    double least = 1e9;
    for (const PlanBox* const of : {&a, &b})
        for (const glm::dvec2& axis : {of->along, glm::dvec2(-of->along.y, of->along.x)})
        {
            double reachM = 0.0;
            for (const PlanBox* const box : {&a, &b})
                reachM += box->halfM.x * std::abs(glm::dot(box->along, axis)) +
                          box->halfM.y * std::abs(glm::dot(glm::dvec2(-box->along.y, box->along.x), axis));
            least = std::min(least, reachM - std::abs(glm::dot(a.middle - b.middle, axis)));
        }
    return least;
}

TEST(TrafficContact, MeasuresDepth)
{
    const PlanBox one{{0.0, 0.0}, {1.0, 0.0}, {2.0, 1.0}};
    EXPECT_NEAR(depthOf(one, {{3.9, 0.0}, {1.0, 0.0}, {2.0, 1.0}}), 0.1, 1e-12);
    EXPECT_NEAR(depthOf(one, {{4.5, 0.0}, {1.0, 0.0}, {2.0, 1.0}}), -0.5, 1e-12);
    EXPECT_NEAR(depthOf(one, {{2.5, 0.0}, {0.0, 1.0}, {2.0, 1.0}}), 0.5, 1e-12);
}

/// Hands that hold the inputs as they are.
class Held final : public simulation::VehicleController
{
public:
    Held(double throttle, double brake) : _throttle(throttle), _brake(brake) {}

    void control(const simulation::ControlView&, std::span<double> inputs) override
    {
        inputs[static_cast<std::size_t>(RoadInput::throttle)] = _throttle;
        inputs[static_cast<std::size_t>(RoadInput::brake)] = _brake;
        inputs[static_cast<std::size_t>(RoadInput::gear)] = _throttle > 0.0 ? 4.0 : 0.0;
    }

private:
    double _throttle, _brake;
};

/// Where the person begins, and what it does.
struct Person
{
    double xM = 0.0, yM = 0.0, headingRad = 0.0, speedMps = 0.0;
    double throttle = 0.0, brake = 0.0;
    bool meetsOthers = true;
};

/// Somebody who keeps the rules, on a lane with a speed.
struct Other
{
    double sM = 0.0;
    int lane = -1;
    double speedMps = 0.0;
};

struct Met
{
    std::shared_ptr<simulation::VehicleMotion> motion;
    std::unique_ptr<simulation::ScenarioPlayer> player;
    simulation::RoadVehicleData data;
    double deepestM = -1e9;      ///< of the person's hull in the box of somebody
    double deepestOtherM = -1e9; ///< of two others

    const EntityState& entity(std::size_t index) const { return player->entities()[index]; }

    void playTo(double untilS)
    {
        while (player->timeS() < untilS)
        {
            player->step();
            const std::size_t count = player->entities().size();
            for (std::size_t i = 1; i < count; ++i)
            {
                for (const simulation::HullBox& hull : data.hull.boxes)
                    deepestM = std::max(
                        deepestM, depthOf(planOf(entity(0), hull.place, glm::dvec2(hull.sizeM)), boxOf(i)));
                for (std::size_t j = i + 1; j < count; ++j)
                    deepestOtherM = std::max(deepestOtherM, depthOf(boxOf(i), boxOf(j)));
            }
        }
    }

    PlanBox boxOf(std::size_t index) const
    {
        const BoundingBox& box = player->scenario().entities[index].box();
        return planOf(entity(index), box.centre, {box.lengthM, box.widthM});
    }
};

simulation::ScenarioText amongOthers(const Person& person, const std::vector<Other>& others)
{
    simulation::ScenarioText text;
    text.privates = simulation::teleport("<WorldPosition x=\"" + std::to_string(person.xM) + "\" y=\"" +
                                         std::to_string(person.yM) + "\" z=\"0\" h=\"" +
                                         std::to_string(person.headingRad) + "\"/>") +
                    simulation::speedAction(person.speedMps);
    for (std::size_t i = 0; i < others.size(); ++i)
    {
        const std::string name = "Other" + std::to_string(i + 1);
        text.entities += "<ScenarioObject name=\"" + name + "\">" + simulation::kCar +
                         controller("IntelligentDriver", property("keepsRules", "true")) +
                         "</ScenarioObject>";
        text.globals += "<Private entityRef=\"" + name + "\">" + onLane(others[i].sM, others[i].lane) +
                        simulation::speedAction(others[i].speedMps) + activate("true", "") + "</Private>";
    }
    text.stop = simulation::stopAt(1000.0);
    return text;
}

Met met(const Person& person, const std::vector<Other>& others)
{
    Met made;
    auto data = simulation::readRoadVehicle(kCarFile);
    EXPECT_TRUE(data) << data.error().message();
    made.data = *data;
    const Roads roads = straight();
    const auto ground = std::make_shared<simulation::RoadSceneGround>(roads);
    made.motion = std::make_shared<simulation::VehicleMotion>(
        std::make_unique<simulation::ControlledVehicle>(
            std::make_unique<simulation::RoadVehicle>(
                std::make_shared<const simulation::RoadVehicleData>(*data)),
            std::make_unique<Held>(person.throttle, person.brake)),
        ground, std::make_shared<const simulation::WeatherAir>());
    if (person.meetsOthers) made.motion->meetOthers();
    auto parsed = simulation::parseScenario(amongOthers(person, others).text(), "test.xosc",
                                            {.tolerant = true, .parameters = {}});
    EXPECT_TRUE(parsed) << parsed.error().message();
    simulation::PlayerOptions options;
    options.clock = simulation::FixedClock(120);
    options.roads = roads;
    options.motions["Ego"] = made.motion;
    auto player = simulation::ScenarioPlayer::create(std::move(parsed->scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    made.player = std::move(*player);
    return made;
}

/// The person comes towards them on their lane, faster than they can clear it; the second one follows.
const std::vector<Other> kComing{{300.0, 1, 13.0}, {330.0, 1, 13.0}};
constexpr Person kAgainstThem{.xM = 100.0, .yM = 1.75, .speedMps = 25.0, .throttle = 0.4};

TEST(TrafficContact, HeadOnIsToldAndTheNextOneStopsBehindTheWreck)
{
    Met play = met(kAgainstThem, kComing);
    play.playTo(60.0);
    ASSERT_FALSE(play.motion->impacts().empty());
    const simulation::Impact& impact = play.motion->impacts().front();
    EXPECT_EQ(impact.name, "Other1");
    EXPECT_EQ(impact.kind, simulation::ObstacleKind::vehicle);
    EXPECT_GT(impact.closingMps, 15.0);
    EXPECT_NE(play.motion->note().find("crashed"), std::string::npos) << play.motion->note();
    EXPECT_LE(play.deepestM, kMostDepthM);
    EXPECT_LT(play.deepestOtherM, 0.0) << "the second one stops behind the first one";
    EXPECT_EQ(play.entity(1).speedMps, 0.0);
    EXPECT_LT(play.entity(2).speedMps, 0.1);
    EXPECT_GT(play.entity(2).position.x, play.entity(1).position.x + 5.0);
}

/// The mutation: a car that meets nobody drives through them, and the depth shows it.
TEST(TrafficContact, ACarThatMeetsNobodyDrivesThrough)
{
    Person person = kAgainstThem;
    person.meetsOthers = false;
    Met play = met(person, kComing);
    play.playTo(20.0);
    EXPECT_TRUE(play.motion->impacts().empty());
    EXPECT_GT(play.deepestM, 0.5);
}

TEST(TrafficContact, WhoIsHitFromBehindStops)
{
    Met play = met({.xM = 100.0, .yM = -1.75, .speedMps = 30.0, .throttle = 0.5},
                   {{150.0, -1, 12.0}, {110.0 - 60.0, -1, 13.0}});
    play.playTo(60.0);
    ASSERT_FALSE(play.motion->impacts().empty());
    EXPECT_EQ(play.motion->impacts().front().name, "Other1");
    EXPECT_LE(play.deepestM, kMostDepthM);
    EXPECT_EQ(play.entity(1).speedMps, 0.0);
    EXPECT_LT(play.entity(2).speedMps, 0.1) << "it stands behind the wreck";
    EXPECT_LT(play.entity(2).position.x, play.entity(0).position.x);
    EXPECT_TRUE(play.entity(2).collidesWith.empty());
}

/// A person who stands in the way of somebody who comes too fast to stop: it is pushed, and not driven over.
TEST(TrafficContact, WhoCannotStopPushesAndStops)
{
    Met play = met({.xM = 130.0, .yM = -1.75, .brake = 1.0}, {{120.0, -1, 14.0}, {70.0, -1, 14.0}});
    play.playTo(40.0);
    ASSERT_FALSE(play.motion->impacts().empty());
    EXPECT_EQ(play.motion->impacts().front().name, "Other1");
    EXPECT_LE(play.deepestM, kMostDepthM);
    EXPECT_EQ(play.entity(1).speedMps, 0.0);
    EXPECT_GT(play.entity(0).position.x, play.entity(1).position.x);
    EXPECT_LT(play.entity(2).position.x, play.entity(1).position.x - 5.0);
    EXPECT_LT(play.deepestOtherM, 0.0);
}

/// The control: with room to stop there is no contact, and it goes on when the person has gone.
TEST(TrafficContact, WhoCanStopDoesNotTouch)
{
    Met play = met({.xM = 200.0, .yM = -1.75, .brake = 1.0}, {{100.0, -1, 13.0}});
    play.playTo(30.0);
    EXPECT_TRUE(play.motion->impacts().empty());
    EXPECT_LT(play.deepestM, 0.0);
    EXPECT_LT(play.entity(1).speedMps, 0.1);
}

} // namespace
