// SPDX-License-Identifier: Apache-2.0
// Vehicles on the ground, against it, and against each other.
#include <cmath>
#include <cstring>

#include <gmock/gmock.h>

#include "RoadSupport.h"

namespace
{

using namespace simulation;
using testsupport::roadVehicle;
using testsupport::setInput;
using testsupport::stepFor;

class NoGround : public Ground
{
public:
    void below(std::span<const glm::dvec3>, std::span<GroundPoint> answers) const override
    {
        for (GroundPoint& answer : answers)
            answer = {};
    }
};

/// Level up to x = 60, then a wall or an edge.
class Obstacle : public Ground
{
public:
    enum class Kind
    {
        wall,
        cliff
    };

    explicit Obstacle(Kind kind) : _kind(kind) {}

    void below(std::span<const glm::dvec3> points, std::span<GroundPoint> answers) const override
    {
        for (std::size_t i = 0; i < points.size(); ++i)
            answers[i] = {heightAt(points[i]), {0.0, 0.0, 1.0}, GroundKind::asphalt, true};
    }

private:
    double heightAt(const glm::dvec3& point) const
    {
        if (point.x < 60.0) return 0.0;
        return _kind == Kind::wall ? 3.0 : -20.0;
    }

    Kind _kind;
};

class VehicleOnGround : public testing::TestWithParam<const char*>
{
};

TEST_P(VehicleOnGround, StandsStillWhereItIsPut)
{
    const auto data = roadVehicle(GetParam());
    RoadVehicle vehicle(data);
    const LevelGround ground(2.0, GroundKind::asphalt);
    vehicle.place({{5.0, -3.0, 0.0}, 1.0, 0.0}, ground);
    setInput(vehicle, RoadInput::brake, 1.0);
    stepFor(vehicle, ground, 3.0);
    const VehicleState before = vehicle.state();
    const glm::dvec3 reference = before.position + before.bodyToScene * vehicle.referencePoint();
    EXPECT_LT(glm::length(reference - glm::dvec3(5.0, -3.0, 2.0)), 0.01) << reference.x << ' ' << reference.z;
    double least = 1e9, most = -1e9;
    for (int i = 0; i < 600; ++i)
    {
        stepFor(vehicle, ground, RoadVehicle::kStepS);
        least = std::min(least, vehicle.wheels()[0].travelM);
        most = std::max(most, vehicle.wheels()[0].travelM);
    }
    EXPECT_LT(most - least, 5e-4);
    EXPECT_LT(glm::length(vehicle.state().position - before.position), 5e-4);
    EntityState entity;
    vehicle.writeParts(entity);
    for (const double travel : entity.wheelTravelM)
        EXPECT_NEAR(travel, 0.0, 0.01);
}

TEST_P(VehicleOnGround, RunsIntoAWallAndCountsAsCrashed)
{
    RoadVehicle vehicle(roadVehicle(GetParam()));
    const Obstacle ground(Obstacle::Kind::wall);
    vehicle.place({{20.0, 0.0, 0.0}, 0.0, 25.0}, ground);
    stepFor(vehicle, ground, 6.0);
    EXPECT_EQ(vehicle.status().condition, VehicleCondition::crashed);
    EXPECT_EQ(vehicle.status().reason, "it hit something hard");
    EXPECT_LT(vehicle.state().position.x, 62.0);
    EXPECT_LT(vehicle.state().position.z, 3.0);
}

TEST_P(VehicleOnGround, FallsDownACliffAndLies)
{
    RoadVehicle vehicle(roadVehicle(GetParam()));
    const Obstacle ground(Obstacle::Kind::cliff);
    vehicle.place({{20.0, 0.0, 0.0}, 0.0, 20.0}, ground);
    stepFor(vehicle, ground, 12.0);
    EXPECT_EQ(vehicle.status().condition, VehicleCondition::crashed);
    EXPECT_NEAR(vehicle.state().position.z, -19.0, 1.8);
    EXPECT_LT(glm::length(vehicle.state().velocity), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Vehicles, VehicleOnGround, testing::ValuesIn(testsupport::kVehicleNames));

// With tyres that grip better than a van is wide over its height, a hard turn tips it; with its own it
// slides.
TEST(RoadVehicleTest, RollsOverWhereTyresHoldMoreThanItsWidthBears)
{
    RoadVehicleData sticky = *roadVehicle("van");
    for (AxleData& axle : sticky.axles)
        axle.tyre.frictionAcross = 2.0;
    sticky.hull.crashesAtMps = 50.0; // it is not the impact that counts
    const LevelGround ground(0.0, GroundKind::asphalt);
    for (const bool isSticky : {true, false})
    {
        RoadVehicle vehicle(isSticky ? std::make_shared<const RoadVehicleData>(sticky) : roadVehicle("van"));
        vehicle.place({{0.0, 0.0, 0.0}, 0.0, 30.0}, ground);
        setInput(vehicle, RoadInput::steering, 0.5);
        stepFor(vehicle, ground, 8.0);
        EXPECT_EQ(vehicle.status().reason, isSticky ? "it rolled over" : "");
        const glm::dvec3 up = vehicle.state().bodyToScene * glm::dvec3(0.0, 0.0, 1.0);
        EXPECT_EQ(up.z < 0.5, isSticky) << up.z;
    }
}

TEST(RoadVehicleTest, SaysWhenThereIsNoGroundOrWater)
{
    RoadVehicle vehicle(roadVehicle());
    const WeatherAir air;
    const auto nowhere = vehicle.begin({{3.0, 4.0, 0.0}, 0.0, 0.0}, NoGround(), air);
    ASSERT_FALSE(nowhere);
    EXPECT_THAT(nowhere.error().message(), testing::HasSubstr("3 m east, 4 m north"));
    EXPECT_THAT(nowhere.error().message(), testing::HasSubstr("there is no ground"));
    const auto drowned = vehicle.begin({}, LevelGround(0.0, GroundKind::water), air);
    ASSERT_FALSE(drowned);
    EXPECT_THAT(drowned.error().message(), testing::HasSubstr("lies in water"));
    const VehicleState before = vehicle.state();
    const auto buried = vehicle.begin({{0.0, 0.0, -50.0}, 0.0, 0.0}, LevelGround(), air);
    ASSERT_FALSE(buried);
    EXPECT_THAT(buried.error().message(),
                testing::HasSubstr("lies 50 m inside the ground; raise it above -1 m"));
    EXPECT_EQ(vehicle.state().position, before.position); // refused: it is as before
    EXPECT_EQ(vehicle.status().condition, VehicleCondition::sound);
    EXPECT_TRUE(
        vehicle.begin({{0.0, 0.0, -0.5}, 0.0, 0.0}, LevelGround(), air)); // hardly inside: put onto it
    EXPECT_GT(vehicle.state().position.z, 0.0);
    stepFor(vehicle, NoGround(), 0.1);
    EXPECT_EQ(vehicle.status().condition, VehicleCondition::failed);
    EXPECT_EQ(vehicle.status().reason, "there is no ground below it");
    vehicle.place({{NAN, 0.0, 0.0}, 0.0, 0.0}, LevelGround());
    EXPECT_EQ(vehicle.status().condition, VehicleCondition::failed);
    vehicle.place({}, LevelGround(0.0, GroundKind::water));
    stepFor(vehicle, LevelGround(0.0, GroundKind::water), 1.0);
    EXPECT_EQ(vehicle.status().reason, "it drove into water");
}

// A car that runs into one that stands: both crash, momentum is shared, neither goes through the other.
TEST(RoadVehicleTest, MeetsAnother)
{
    const auto world = std::make_shared<BodyWorld>();
    RoadVehicle standing(roadVehicle(), nullptr, world), running(roadVehicle(), nullptr, world);
    const LevelGround ground(0.0, GroundKind::asphalt);
    const WeatherAir air;
    standing.place({{30.0, 0.2, 0.0}, 0.0, 0.0}, ground);
    running.place({{0.0, 0.0, 0.0}, 0.0, 20.0}, ground);
    RoadVehicle* const both[] = {&standing, &running};
    double fastest = 0.0;
    for (int i = 0; i < 480; ++i)
    {
        RoadVehicle::stepTogether(both, ground, air);
        fastest = std::max(fastest, standing.readings().speedMps);
        ASSERT_GT(glm::length(standing.state().position - running.state().position), 2.0);
    }
    EXPECT_EQ(standing.status().condition, VehicleCondition::crashed);
    EXPECT_EQ(running.status().condition, VehicleCondition::crashed);
    EXPECT_NEAR(fastest, 10.5, 1.5);
}

// The same inputs give the same bytes.
TEST(RoadVehicleTest, TwoRunsAreEqual)
{
    const auto run = [](double steering)
    {
        RoadVehicle vehicle(roadVehicle());
        const LevelGround ground(0.0, GroundKind::gravel);
        vehicle.place({{0.0, 0.0, 0.0}, 0.3, 15.0}, ground);
        setInput(vehicle, RoadInput::gear, 1.0);
        setInput(vehicle, RoadInput::throttle, 0.4);
        setInput(vehicle, RoadInput::steering, steering);
        stepFor(vehicle, ground, 5.0);
        return vehicle.state();
    };
    const VehicleState first = run(0.1), second = run(0.1), other = run(0.1000001);
    EXPECT_EQ(std::memcmp(&first.position, &second.position, sizeof first.position), 0);
    EXPECT_EQ(std::memcmp(&first.bodyToScene, &second.bodyToScene, sizeof first.bodyToScene), 0);
    EXPECT_NE(std::memcmp(&first.position, &other.position, sizeof first.position), 0);
}

} // namespace
