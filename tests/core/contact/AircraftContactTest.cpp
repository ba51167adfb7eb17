// SPDX-License-Identifier: Apache-2.0
// An aeroplane against a house, a tree, a mast, the ground and water, at several speeds and angles.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>

#include <foundation/Angle.h>

#include "../flight/FlightSupport.h"
#include "simulation/contact/ObstacleMap.h"
#include "simulation/vehicle/flight/AircraftHull.h"

namespace
{

using namespace simulation;

constexpr double kRestDepthM = 0.05;
constexpr double kLongestS = 40.0; ///< after which a wreck on land must lie still

enum class Target
{
    house,
    tree,
    mast,
    hangarDoor, ///< low enough that wings alone reach it
    ground,
    water
};

Obstacle obstacleOf(Target target)
{
    Obstacle thing;
    thing.lowM = -1.0;
    switch (target)
    {
    case Target::house:
        thing.kind = ObstacleKind::house;
        thing.halfM = {6.0, 5.0};
        thing.highM = 7.0;
        break;
    case Target::tree:
        thing.kind = ObstacleKind::tree;
        thing.isRound = true;
        thing.halfM = glm::dvec2(0.35);
        thing.highM = 16.0;
        break;
    case Target::mast:
        thing.kind = ObstacleKind::mast;
        thing.isRound = true;
        thing.halfM = glm::dvec2(0.12);
        thing.highM = 25.0;
        break;
    default:
        thing.kind = ObstacleKind::wall;
        thing.halfM = {15.0, 0.3};
        thing.highM = 2.5;
        break;
    }
    return thing;
}

ObstacleKind kindOf(Target target)
{
    if (target == Target::ground) return ObstacleKind::ground;
    if (target == Target::water) return ObstacleKind::water;
    return obstacleOf(target).kind;
}

double depthIn(const Obstacle& thing, const glm::dvec3& point)
{
    const double inHeight = std::min(thing.highM - point.z, point.z - thing.lowM);
    const glm::dvec2 apart = glm::dvec2(point) - thing.middle;
    if (thing.isRound) return std::min(inHeight, thing.halfM.x - glm::length(apart));
    return std::min({inHeight, thing.halfM.x - std::abs(apart.x), thing.halfM.y - std::abs(apart.y)});
}

/// The deepest of points all over the hull in a thing and in the ground, and of the thing's upright lines in
/// the hull.
double deepestIn(const Aircraft& aircraft, const Obstacle* thing, double groundM)
{
    const VehicleState state = aircraft.state();
    const glm::dvec3 centre =
        hullPlace(massProperties(aircraft.data(), aircraft.flightState().fuelKg).centre);
    double deepest = -1.0;
    for (const HullBox& box : aircraft.data().hull.boxes)
    {
        const auto inScene = [&](const glm::dvec3& share)
        { return state.position + state.bodyToScene * (box.place - centre + 0.5 * box.sizeM * share); };
        for (int x = -8; x <= 8; ++x)
            for (int y = -8; y <= 8; ++y)
                for (const double z : {-1.0, 0.0, 1.0})
                {
                    const glm::dvec3 point = inScene({x / 8.0, y / 8.0, z});
                    deepest = std::max(deepest, groundM - point.z);
                    if (thing) deepest = std::max(deepest, depthIn(*thing, point));
                }
        for (int i = 0; thing && i < 16; ++i)
            for (int k = 1; k < 24; ++k)
            {
                const double turn = i * std::numbers::pi / 8.0;
                const glm::dvec2 corner(i % 4 < 2 ? 1.0 : -1.0, i % 2 == 0 ? 1.0 : -1.0);
                const glm::dvec2 at = thing->isRound
                                          ? thing->halfM.x * glm::dvec2(std::cos(turn), std::sin(turn))
                                          : corner * thing->halfM;
                const glm::dvec3 point(thing->middle + at,
                                       thing->lowM + (thing->highM - thing->lowM) * k / 24.0);
                const glm::dvec3 inBox =
                    glm::conjugate(state.bodyToScene) * (point - state.position) + centre - box.place;
                const glm::dvec3 room = 0.5 * box.sizeM - glm::abs(inBox);
                deepest = std::max(deepest, std::min({room.x, room.y, room.z}));
            }
    }
    return deepest;
}

struct Wrecking
{
    double restM = -1.0;  ///< how deep the hull lies in anything, at the end
    double gainedJ = 0.0; ///< the most that energy rose from one step to the next, after the first impact
    double risenJ = 0.0;  ///< above what it was at the first impact
    double restS = 0.0, endMps = 0.0, highestM = 0.0;
    std::vector<Impact> impacts;
    VehicleStatus status;
    glm::dvec3 end{0.0}, beforeMps{0.0};
    double endTurn = 0.0;

    auto bytes() const { return std::tuple(restM, gainedJ, restS, end.x, end.y, end.z, endTurn); }
};

/// A heading (degrees from north), a path down (degrees) and a bank (degrees), towards the origin at a
/// height.
struct Arrival
{
    double speedMps = 40.0, downDeg = 3.0, bankDeg = 0.0, headingDeg = 0.0, heightM = 3.0, asideM = 0.0;
    double onWaterS = 12.0; ///< how long water is watched
};

Wrecking arrive(Target target, const Arrival& how, bool meets = true)
{
    static const auto data = testsupport::lightSingle();
    static const auto earth = testsupport::earthHere();
    Aircraft aircraft(data, earth);
    const double longestS = target == Target::water ? how.onWaterS : kLongestS;
    const bool stands = target != Target::ground && target != Target::water;
    const Obstacle thing = obstacleOf(target);
    ObstacleList list;
    list.add(thing, "the thing");
    if (meets && stands) aircraft.meet(std::make_shared<const ObstacleMap>(list));
    const LevelGround ground(0.0, target == Target::water ? GroundKind::water : GroundKind::grass);
    const double bedM = target == Target::water ? -5.0 : 0.0;
    const double heading = foundation::radiansOf(how.headingDeg), down = foundation::radiansOf(how.downDeg);
    const glm::dvec3 ahead(std::sin(heading) * std::cos(down), std::cos(heading) * std::cos(down),
                           -std::sin(down));
    FlightState state = aircraft.flightState();
    state.motion.position =
        glm::dvec3(how.asideM * std::cos(heading), -how.asideM * std::sin(heading), how.heightM) -
        16.0 * ahead;
    state.motion.velocity = how.speedMps * ahead;
    state.motion.attitude = levelAttitude(earth->placeAt(state.motion.position), heading, -down,
                                          foundation::radiansOf(how.bankDeg));
    state.motion.rates = glm::conjugate(state.motion.attitude) * earth->earthRate();
    state.engineRadps = 0.0;
    aircraft.place(state);
    testsupport::setInput(aircraft, FlightInput::ignition, 0.0);
    testsupport::setInput(aircraft, FlightInput::elevator, 0.5); // it is not to fly away over it
    const WeatherAir air;
    Wrecking run;
    double lastJ = 0.0, hitJ = 0.0;
    for (int i = 0; i < static_cast<int>(longestS / Aircraft::kStepS); ++i)
    {
        if (aircraft.impacts().empty()) run.beforeMps = aircraft.state().velocity;
        const bool hadHit = !aircraft.impacts().empty();
        aircraft.step(ground, air);
        const double nowJ = aircraft.energyJ();
        if (hadHit)
        {
            run.gainedJ = std::max(run.gainedJ, nowJ - lastJ);
            run.risenJ = std::max(run.risenJ, nowJ - hitJ);
        }
        else
            hitJ = nowJ;
        lastJ = nowJ;
        if (aircraft.status().condition == VehicleCondition::crashed)
            run.highestM = std::max(run.highestM, aircraft.state().position.z);
        if (glm::length(aircraft.state().velocity) > 0.0) run.restS = aircraft.state().timeS;
        if (aircraft.state().timeS - run.restS > 0.1) break; // it lies still, and stays so
    }
    run.restM = deepestIn(aircraft, stands ? &thing : nullptr, bedM);
    run.endMps = glm::length(aircraft.state().velocity);
    run.impacts.assign(aircraft.impacts().begin(), aircraft.impacts().end());
    run.status = aircraft.status();
    run.end = aircraft.state().position;
    run.endTurn = aircraft.state().bodyToScene.w;
    return run;
}

class AircraftAgainst : public testing::TestWithParam<Target>
{
};

/// Speeds and angles of an approach by a number.
Arrival nth(int number)
{
    constexpr std::array<double, 5> kSpeeds{15.0, 25.0, 35.0, 50.0, 65.0};
    constexpr std::array<double, 4> kDown{5.0, 12.0, 25.0, 60.0};
    Arrival how;
    how.speedMps = kSpeeds[static_cast<std::size_t>(number) % kSpeeds.size()];
    how.downDeg = kDown[static_cast<std::size_t>(number / 5) % kDown.size()];
    how.bankDeg = 8.0 * (number % 7 - 3);
    how.headingDeg = 37.0 * number;
    how.heightM = 3.0 + 0.7 * (number % 4);
    how.asideM = 1.5 * (number % 5 - 2);
    return how;
}

/// `every`: of the twenty approaches, each so many.
void arriveEach(Target target, int every)
{
    double deepestM = -1.0, longestS = 0.0, gainedJ = 0.0;
    for (int number = 0; number < 20; number += every)
    {
        Arrival how = nth(number);
        if (target == Target::hangarDoor)
        {
            how.headingDeg = 8.0 * (number % 5 - 2); // across it
            how.heightM = 2.0;
        }
        const Wrecking run = arrive(target, how);
        SCOPED_TRACE(std::to_string(number) + ": " + std::to_string(how.speedMps) + " m/s, down " +
                     std::to_string(how.downDeg));
        ASSERT_NE(run.status.condition, VehicleCondition::failed) << run.status.reason;
        ASSERT_TRUE(std::isfinite(run.end.x + run.end.y + run.end.z + run.endTurn));
        EXPECT_LE(run.restM, kRestDepthM);
        // Contacts that were pressed into each other are set apart, by centimetres.
        EXPECT_LT(run.risenJ, 2000.0) << "energy grew";
        EXPECT_LT(run.highestM, 25.0) << "launched";
        ASSERT_FALSE(run.impacts.empty());
        EXPECT_EQ(run.status.condition, VehicleCondition::crashed);
        EXPECT_TRUE(std::any_of(run.impacts.begin(), run.impacts.end(),
                                [&](const Impact& impact) { return impact.kind == kindOf(target); }) ||
                    how.asideM != 0.0 || how.downDeg > 10.0)
            << textOf(run.impacts.front());
        EXPECT_NEAR(run.impacts.front().speedMps, glm::length(run.beforeMps), 0.2 + 0.02 * how.speedMps);
        EXPECT_GT(glm::dot(run.impacts.front().direction, glm::normalize(run.beforeMps)), 0.99);
        if (target != Target::water)
        {
            EXPECT_LT(run.endMps, 0.03) << "it lies still";
        }
        deepestM = std::max(deepestM, run.restM);
        longestS = std::max(longestS, run.restS);
        gainedJ = std::max(gainedJ, run.risenJ);
    }
    std::printf(
        "deepest %.3f m at rest, still after %.1f s at most, %.0f J gained at most, of %d approaches\n",
        deepestM, longestS, gainedJ, (19 + every) / every);
}

TEST_P(AircraftAgainst, ComesToRestOutsideAndGainsNoEnergy)
{
    arriveEach(GetParam(), 7);
}

class AircraftAgainstInFull : public AircraftAgainst
{
};

TEST_P(AircraftAgainstInFull, ComesToRestOutsideAndGainsNoEnergy)
{
    arriveEach(GetParam(), 1);
}

std::string targetName(const testing::TestParamInfo<Target>& info)
{
    constexpr std::array<const char*, 6> kNames{"House", "Tree", "Mast", "Wall", "Ground", "Water"};
    return kNames[static_cast<std::size_t>(info.param)];
}

const auto kTargets = testing::Values(Target::house, Target::tree, Target::mast, Target::hangarDoor,
                                      Target::ground, Target::water);
INSTANTIATE_TEST_SUITE_P(Targets, AircraftAgainst, kTargets, targetName);
INSTANTIATE_TEST_SUITE_P(Targets, AircraftAgainstInFull, kTargets, targetName);

/// The control: the same checks see an aeroplane that meets nothing.
TEST(AircraftContact, AnAeroplaneThatMeetsNothingFliesThrough)
{
    Arrival how;
    how.downDeg = 0.5;
    how.speedMps = 50.0;
    how.heightM = 5.0;
    const Wrecking through = arrive(Target::house, how, false);
    EXPECT_TRUE(std::none_of(through.impacts.begin(), through.impacts.end(),
                             [](const Impact& impact) { return impact.kind == ObstacleKind::house; }));
    EXPECT_GT(through.end.y, 30.0);
    const Wrecking met = arrive(Target::house, how);
    ASSERT_FALSE(met.impacts.empty());
    EXPECT_EQ(met.impacts.front().kind, ObstacleKind::house);
    EXPECT_EQ(met.impacts.front().name, "the thing");
    EXPECT_EQ(met.status.reason, "it hit a house");
    EXPECT_LT(met.end.y, 0.0) << "it stays on its side of the house";
}

TEST(AircraftContact, RepeatsToTheLastBit)
{
    for (const Target target : {Target::tree, Target::ground, Target::water})
    {
        const Wrecking first = arrive(target, nth(3)), second = arrive(target, nth(3));
        EXPECT_EQ(first.bytes(), second.bytes());
        Arrival other = nth(3);
        other.speedMps += 0.01;
        EXPECT_NE(first.bytes(), arrive(target, other).bytes());
    }
}

/// An aeroplane that meets a map of which nothing is near flies as without one, to the last bit.
TEST(AircraftContact, WhatIsFarAwayChangesNothing)
{
    const auto flown = [](bool meets)
    {
        TrimTarget target;
        target.position = {0.0, 0.0, 300.0};
        target.trueAirspeedMps = 50.0;
        const auto flight =
            trim(*testsupport::lightSingle(), *testsupport::earthHere(), testsupport::airAt(300.0), target);
        Aircraft aircraft = testsupport::flying(*flight);
        Obstacle far = obstacleOf(Target::house);
        far.middle = {500.0, 100.0};
        ObstacleList list;
        list.add(far);
        if (meets) aircraft.meet(std::make_shared<const ObstacleMap>(list));
        for (int i = 0; i < 600; ++i)
            aircraft.step(LevelGround(), WeatherAir());
        return aircraft.state();
    };
    const VehicleState alone = flown(false), among = flown(true);
    EXPECT_EQ(alone.position, among.position);
    EXPECT_EQ(alone.bodyToScene, among.bodyToScene);
}

/// Rolls an aeroplane with its engine running to the north, its wing towards a mast.
Aircraft taxied(double speedMps, double mastAsideM)
{
    Aircraft aircraft(testsupport::lightSingle(), testsupport::earthHere());
    EXPECT_TRUE(
        aircraft.begin({{0.0, 0.0, 0.0}, 0.5 * std::numbers::pi, speedMps}, LevelGround(), WeatherAir()));
    Obstacle mast = obstacleOf(Target::mast);
    mast.middle = {mastAsideM, 8.0};
    ObstacleList list;
    list.add(mast, "lamp");
    aircraft.meet(std::make_shared<const ObstacleMap>(list));
    for (int i = 0; i < 1200; ++i)
        aircraft.step(LevelGround(), WeatherAir());
    return aircraft;
}

/// By degree: a slow touch of the wing is told, a faster one bends it, a fast one is the end.
TEST(AircraftContact, AWingIsBentBeforeAllIsLost)
{
    const Aircraft slow = taxied(0.8, 4.5), bent = taxied(4.5, 4.5), lost = taxied(25.0, 3.0);
    EXPECT_EQ(slow.status().condition, VehicleCondition::sound);
    EXPECT_EQ(slow.damage().wingLost[1], 0.0);
    EXPECT_EQ(bent.status().condition, VehicleCondition::sound) << bent.status().reason;
    EXPECT_GT(bent.damage().wingLost[1], 0.0);
    EXPECT_EQ(bent.damage().wingLost[0], 0.0);
    ASSERT_FALSE(bent.impacts().empty());
    EXPECT_EQ(bent.impacts()[0].name, "lamp");
    EXPECT_EQ(bent.impacts()[0].damage, "right wing bent");
    EXPECT_NE(textOf(bent.impacts()[0]).find(": right wing bent"), std::string::npos);
    EXPECT_EQ(lost.status().condition, VehicleCondition::crashed);
    EXPECT_EQ(lost.status().reason, "it hit a mast");
}

TEST(AircraftContact, AnAeroplaneThatIsPlacedAnewIsWhole)
{
    Aircraft aircraft = taxied(4.5, 4.5);
    ASSERT_GT(aircraft.damage().wingLost[1], 0.0);
    aircraft.place(aircraft.flightState());
    EXPECT_EQ(aircraft.damage().wingLost[1], 0.0);
    EXPECT_TRUE(aircraft.impacts().empty());
}

TEST(AircraftContact, APropellerThatStrikesStopsTheEngine)
{
    const Aircraft aircraft = taxied(2.0, 0.3);
    EXPECT_TRUE(aircraft.damage().isPropellerBroken);
    EXPECT_EQ(aircraft.flightState().engineRadps, 0.0);
    ASSERT_FALSE(aircraft.impacts().empty());
    EXPECT_NE(aircraft.impacts()[0].damage.find("propeller broken, engine stopped"), std::string::npos);
    EXPECT_EQ(aircraft.status().condition, VehicleCondition::sound) << "the pilot can brake and get out";
}

/// A hard landing breaks the gear; the belly, not the gear, carries the wreck.
TEST(AircraftContact, AHardLandingBreaksTheGear)
{
    Aircraft aircraft = testsupport::standing();
    FlightState state = aircraft.flightState();
    state.motion.position.z = 2.0;
    state.motion.velocity = {0.0, 28.0, -6.5};
    aircraft.place(state);
    for (int i = 0; i < 2400; ++i)
        aircraft.step(LevelGround(), WeatherAir());
    EXPECT_EQ(aircraft.status().reason, "its gear broke at touchdown");
    ASSERT_FALSE(aircraft.impacts().empty());
    EXPECT_EQ(aircraft.impacts()[0].kind, ObstacleKind::ground);
    EXPECT_NE(aircraft.impacts()[0].damage.find("gear broken"), std::string::npos);
    EXPECT_LT(aircraft.state().position.z, 1.15) << "it stood on its wheels";
    EXPECT_LT(deepestIn(aircraft, nullptr, 0.0), kRestDepthM);
    EntityState entity;
    aircraft.writeParts(entity);
    EXPECT_GT(*std::max_element(entity.aircraft->strutM.begin(), entity.aircraft->strutM.end()), 0.4)
        << "the broken leg is folded in the picture";
}

/// As steep as the report has it: 8 200 ft/min into the sea, and onto the beach.
TEST(AircraftContact, DitchingStopsFloatsAndThenSinksToTheBed)
{
    Arrival how;
    how.speedMps = 60.0;
    how.downDeg = 44.0; // 41.7 m/s down
    how.heightM = 4.0;
    const Wrecking run = arrive(Target::water, how);
    EXPECT_EQ(run.status.condition, VehicleCondition::crashed);
    EXPECT_EQ(run.status.reason, "it came down on water");
    EXPECT_LT(std::hypot(run.end.x, run.end.y), 60.0) << "it slid on";
    ASSERT_FALSE(run.impacts.empty());
    EXPECT_EQ(run.impacts.front().kind, ObstacleKind::water);
    EXPECT_NEAR(run.impacts.front().speedMps, 60.0, 2.0);
    EXPECT_NE(textOf(run.impacts.front()).find("into the water at"), std::string::npos);
    Arrival soft;
    soft.speedMps = 26.0;
    soft.downDeg = 2.0;
    soft.heightM = 1.8;
    const Wrecking floats = arrive(Target::water, soft);
    EXPECT_EQ(floats.status.reason, "it came down on water");
    EXPECT_GT(floats.end.z, -2.0) << "it floats for longer than " << soft.onWaterS << " s";
    EXPECT_LT(floats.end.z, 1.2) << "on the water, not over it";
    soft.onWaterS = 300.0;
    const Wrecking sinks = arrive(Target::water, soft);
    EXPECT_LT(sinks.end.z, -2.5) << "it lies on the bed, 5 m down";
    EXPECT_LT(sinks.restM, 0.1);
    EXPECT_LT(sinks.endMps, 0.05);
}

} // namespace
