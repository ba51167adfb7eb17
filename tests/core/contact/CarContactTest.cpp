// SPDX-License-Identifier: Apache-2.0
// A car against everything that stands: approaches at ten speeds and twenty angles.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "../driving/RoadSupport.h"
#include "simulation/contact/ObstacleMap.h"

namespace
{

using namespace simulation;

constexpr double kMostDepthM = 0.05;
constexpr double kMostHighM = 3.0; ///< of the centre of mass: cars that roll over a rail at 38 m/s

/// The size of a thing of each kind.
Obstacle sizedThing(ObstacleKind kind)
{
    const auto round = [](double radiusM, double highM)
    {
        Obstacle body;
        body.isRound = true;
        body.halfM = glm::dvec2(radiusM);
        body.highM = highM;
        return body;
    };
    const auto box = [](double lengthM, double widthM, double highM)
    {
        Obstacle body;
        body.halfM = {0.5 * lengthM, 0.5 * widthM};
        body.highM = highM;
        return body;
    };
    switch (kind)
    {
    case ObstacleKind::house:
        return box(12.0, 9.0, 6.0);
    case ObstacleKind::wall:
        return box(30.0, 0.4, 1.2);
    case ObstacleKind::fence:
        return box(30.0, 0.1, 1.2);
    case ObstacleKind::guardRail:
        return box(30.0, 0.25, 0.75);
    case ObstacleKind::barrier:
        return box(30.0, 0.6, 0.81);
    case ObstacleKind::bridgeRail:
        return box(30.0, 0.4, 1.1);
    case ObstacleKind::tunnelWall:
        return box(30.0, 0.6, 5.0);
    case ObstacleKind::pillar:
        return round(0.6, 6.0);
    case ObstacleKind::mast:
        return round(0.09, 8.0);
    case ObstacleKind::post:
        return round(0.04, 2.2);
    case ObstacleKind::marker:
        return round(0.15, 0.75);
    case ObstacleKind::tree:
        return round(0.3, 12.0);
    case ObstacleKind::hedge:
        return round(1.5, 2.0);
    case ObstacleKind::vehicle:
        return box(4.5, 1.8, 1.46);
    default:
        return box(1.0, 0.8, 0.6);
    }
}

/// A thing of each kind, its face at the origin.
Obstacle thingOf(ObstacleKind kind)
{
    Obstacle body = sizedThing(kind);
    body.kind = kind;
    body.lowM = -0.3;
    return body;
}

/// How deep a point lies in a thing; 0 or less outside.
double depthOf(const Obstacle& thing, const glm::dvec3& point)
{
    const double inHeight = std::min(thing.highM - point.z, point.z - thing.lowM);
    const glm::dvec2 apart = glm::dvec2(point) - thing.middle;
    if (thing.isRound) return std::min(inHeight, thing.halfM.x - glm::length(apart));
    const double x = std::abs(glm::dot(apart, thing.along)),
                 y = std::abs(glm::dot(apart, glm::dvec2(-thing.along.y, thing.along.x)));
    return std::min({inHeight, thing.halfM.x - x, thing.halfM.y - y});
}

/// The deepest of points all over the hull in a thing, and of the thing's upright lines in the hull.
double deepestOf(const RoadVehicle& car, const Obstacle& thing)
{
    const VehicleState state = car.state();
    double deepest = -1.0;
    for (const HullBox& box : car.data().hull.boxes)
    {
        const auto inScene = [&](const glm::dvec3& share) {
            return state.position +
                   state.bodyToScene * (box.place - car.mass().centre + 0.5 * box.sizeM * share);
        };
        for (int x = -8; x <= 8; ++x)
            for (int y = -4; y <= 4; ++y)
                for (const double z : {-1.0, -0.5, 0.0, 0.5, 1.0})
                    deepest = std::max(deepest, depthOf(thing, inScene({x / 8.0, y / 4.0, z})));
        for (int i = 0; i < 16; ++i)
            for (int k = 1; k < 8; ++k)
            {
                const double turn = i * std::numbers::pi / 8.0;
                const glm::dvec2 corner(i % 4 < 2 ? 1.0 : -1.0, i % 2 == 0 ? 1.0 : -1.0);
                const glm::dvec2 across(-thing.along.y, thing.along.x);
                const glm::dvec2 at =
                    thing.isRound
                        ? thing.halfM.x * glm::dvec2(std::cos(turn), std::sin(turn))
                        : corner.x * thing.halfM.x * thing.along + corner.y * thing.halfM.y * across;
                const glm::dvec3 point(thing.middle + at, thing.lowM + (thing.highM - thing.lowM) * k / 8.0);
                const glm::dvec3 inBox = glm::conjugate(state.bodyToScene) * (point - state.position) +
                                         car.mass().centre - box.place;
                const glm::dvec3 room = 0.5 * box.sizeM - glm::abs(inBox);
                deepest = std::max(deepest, std::min({room.x, room.y, room.z}));
            }
    }
    return deepest;
}

struct Approach
{
    double deepestM = -1.0, highestM = 0.0, gainedJ = 0.0;
    double beforeMps = 0.0, endMps = 0.0; ///< in the step before it hit something; in the end
    std::vector<Impact> impacts;
    VehicleCondition condition = VehicleCondition::sound;
    glm::dvec3 end{0.0};

    auto bytes() const { return std::tuple(deepestM, highestM, endMps, end.x, end.y, end.z); }
};

/// Lets a car roll towards the origin, out of gear, from `aheadM` in front of its bumper.
Approach approach(const Obstacle& thing, double speedMps, double headingRad, bool meets = true)
{
    static const auto data = testsupport::roadVehicle("car");
    constexpr double kAheadM = 4.0, kBumperM = 3.65, kHalfWidthM = 0.95;
    RoadVehicle car(data);
    ObstacleList list;
    list.add(thing, "the thing");
    if (meets) car.meet(std::make_shared<const ObstacleMap>(list));
    const glm::dvec2 ahead(std::cos(headingRad), std::sin(headingRad));
    const double reachM =
        thing.isRound ? thing.halfM.x : (thing.halfM.y + kHalfWidthM) / std::max(0.1, std::abs(ahead.y));
    const LevelGround ground;
    const glm::dvec2 start = -(kAheadM + kBumperM + std::min(reachM, 11.0)) * ahead;
    car.place({glm::dvec3(start, 0.0), headingRad, speedMps}, ground);
    const WeatherAir air;
    Approach run;
    const double beginJ = car.energyJ(), beginM = car.state().position.z;
    const double wayM = kAheadM + std::min(reachM, 11.0);
    const int steps = static_cast<int>(120.0 * (1.5 * wayM / speedMps + 0.7));
    for (int i = 0; i < steps; ++i)
    {
        if (car.impacts().empty()) run.beforeMps = glm::length(car.state().velocity);
        car.step(ground, air);
        if (i % 4 == 0 || i < 2 * steps / 3) run.deepestM = std::max(run.deepestM, deepestOf(car, thing));
        run.highestM = std::max(run.highestM, car.state().position.z - beginM);
        run.gainedJ = std::max(run.gainedJ, car.energyJ() - beginJ);
    }
    run.endMps = glm::length(car.state().velocity);
    run.impacts.assign(car.impacts().begin(), car.impacts().end());
    run.condition = car.status().condition;
    run.end = car.state().position;
    return run;
}

class AgainstEach : public testing::TestWithParam<int>
{
protected:
    static ObstacleKind kind() { return static_cast<ObstacleKind>(GetParam()); }

    /// `every`: of the ten speeds and twenty angles, each so many.
    static void run(int every)
    {
        const Obstacle thing = thingOf(kind());
        double deepestM = -1.0, highestM = 0.0, gainedShare = 0.0;
        int number = 0;
        for (const double speedMps : {4.0, 6.0, 8.0, 11.0, 15.0, 20.0, 25.0, 31.0, 38.0, 45.0})
            for (int angle = 0; angle < 20; ++angle)
            {
                if (number++ % every != 0) continue;
                const double heading = (9.0 + 18.0 * angle) * std::numbers::pi / 180.0;
                const Approach once = approach(thing, speedMps, heading);
                SCOPED_TRACE(std::string(factsOf(kind()).name) + " at " + std::to_string(speedMps) +
                             " m/s, " + std::to_string(angle));
                EXPECT_NE(once.condition, VehicleCondition::failed);
                EXPECT_TRUE(!standsFast(kind()) || once.deepestM <= kMostDepthM) << once.deepestM;
                // Springs that are pressed at the start give a little.
                const double beginJ = 750.0 * speedMps * speedMps;
                EXPECT_LE(once.gainedJ, 0.01 * beginJ + 400.0);
                EXPECT_LT(once.highestM, kMostHighM) << "no launch into the sky";
                ASSERT_FALSE(once.impacts.empty());
                EXPECT_EQ(once.impacts.front().kind, kind());
                EXPECT_EQ(once.impacts.front().name, "the thing");
                EXPECT_NEAR(once.impacts.front().speedMps, once.beforeMps, 1e-9);
                EXPECT_LT(once.impacts.front().closingMps, 1.2 * speedMps);
                EXPECT_LE(once.endMps, speedMps);
                deepestM = std::max(deepestM, once.deepestM);
                highestM = std::max(highestM, once.highestM);
                gainedShare = std::max(gainedShare, once.gainedJ / beginJ);
            }
        std::printf(
            "%s: deepest %.3f m, highest %.2f m, energy gained %.4f of what it had, in %d approaches\n",
            std::string(factsOf(kind()).name).c_str(), deepestM, highestM, gainedShare,
            (number + every - 1) / every);
    }
};

TEST_P(AgainstEach, StaysOutsideAndGainsNoEnergy)
{
    run(13);
}

class AgainstEachInFull : public AgainstEach
{
};

TEST_P(AgainstEachInFull, StaysOutsideAndGainsNoEnergyAtTwoHundredApproaches)
{
    run(1);
}

std::string kindName(const testing::TestParamInfo<int>& info)
{
    std::string name(factsOf(static_cast<ObstacleKind>(info.param)).name);
    std::erase(name, ' ');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Kinds, AgainstEach, testing::Range(0, kStandingKinds), kindName);
INSTANTIATE_TEST_SUITE_P(Kinds, AgainstEachInFull, testing::Range(0, kStandingKinds), kindName);

/// The control: the same checks see a car that meets nothing.
TEST(CarContact, ACarThatMeetsNothingDrivesThrough)
{
    const Approach through = approach(thingOf(ObstacleKind::house), 15.0, 1.2, false);
    EXPECT_GT(through.deepestM, 0.3);
    EXPECT_TRUE(through.impacts.empty());
    EXPECT_GT(through.endMps, 14.0);
}

TEST(CarContact, RepeatsToTheLastBit)
{
    for (const ObstacleKind kind : {ObstacleKind::tree, ObstacleKind::guardRail, ObstacleKind::post})
    {
        const Approach first = approach(thingOf(kind), 17.0, 0.4),
                       second = approach(thingOf(kind), 17.0, 0.4);
        EXPECT_EQ(first.bytes(), second.bytes());
        EXPECT_NE(first.bytes(), approach(thingOf(kind), 17.0, 0.41).bytes());
    }
}

TEST(CarContact, AWallEndsADrive)
{
    const Approach run = approach(thingOf(ObstacleKind::wall), 15.0, 0.5 * std::numbers::pi);
    EXPECT_EQ(run.condition, VehicleCondition::crashed);
    // Restitution 0.1: it comes back with a tenth of its speed at most, and brakes.
    EXPECT_LT(run.endMps, 2.0);
    ASSERT_FALSE(run.impacts.empty());
    EXPECT_NEAR(run.impacts.front().closingMps, 15.0, 3.0);
    EXPECT_NEAR(run.impacts.front().direction.y, 1.0, 0.01);
    EXPECT_NEAR(run.impacts.front().place.y, -0.2, 0.1);
}

TEST(CarContact, ARailGuides)
{
    // 10° at 20 m/s: 3.5 m/s across the rail are lost, what is along stays but for friction.
    const Approach run = approach(thingOf(ObstacleKind::guardRail), 20.0, 10.0 * std::numbers::pi / 180.0);
    EXPECT_GT(run.endMps, 14.0);
    EXPECT_LT(run.end.y, 0.0) << "on its own side";
}

TEST(CarContact, APostBreaksAndAMastDoesNot)
{
    const Approach post = approach(thingOf(ObstacleKind::post), 20.0, 0.3);
    EXPECT_EQ(post.condition, VehicleCondition::sound);
    // 600 N s of 1 500 kg: 0.4 m/s.
    EXPECT_NEAR(post.endMps, 19.5, 0.4);
    ASSERT_EQ(post.impacts.size(), 1U);
    EXPECT_TRUE(post.impacts.front().hasGiven);
    const Approach mast = approach(thingOf(ObstacleKind::mast), 20.0, 0.3);
    EXPECT_EQ(mast.condition, VehicleCondition::crashed);
    EXPECT_LT(mast.endMps, 12.0);
}

TEST(CarContact, AHedgeSlows)
{
    const Approach hedge = approach(thingOf(ObstacleKind::hedge), 10.0, 0.3);
    EXPECT_EQ(hedge.condition, VehicleCondition::sound);
    EXPECT_LT(hedge.endMps, 9.0);
    EXPECT_GT(hedge.endMps, 3.0);
}

TEST(CarContact, TellsAnImpactInALine)
{
    Impact impact;
    impact.timeS = 12.3;
    impact.speedMps = 15.0;
    impact.place = {120.34, 44.0, 3.0};
    impact.kind = ObstacleKind::tree;
    impact.name = "oak";
    EXPECT_EQ(textOf(impact), "after 12.30 s at 54 km/h into a tree (oak) at 120.3, 44.0");
    impact.name = "tree";
    EXPECT_EQ(textOf(impact, 1.0), "after 13.30 s at 54 km/h into a tree at 120.3, 44.0");
}

} // namespace
