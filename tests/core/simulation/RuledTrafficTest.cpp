// SPDX-License-Identifier: Apache-2.0
// Traffic that keeps the rules, on a crossing of four streets of which two and two are joined by loops, so
// that nobody comes to an end: 1.5 km of street.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "../roads/RoadTexts.h"
#include "simulation/player/EntityDistance.h"
#include "simulation/player/ScenarioPlayer.h"
#include "simulation/road/JunctionTable.h"
#include "simulation/scenario/DefaultVehicle.h"
#include "simulation/scenario/SessionTraffic.h"

namespace simulation
{
namespace
{

constexpr double kHalfM = 15.0, kArmM = 100.0;

std::string link(const std::string& name, const std::string& type, int id, const std::string& contact = "")
{
    return "<" + name + " elementType=\"" + type + "\" elementId=\"" + std::to_string(id) + "\"" +
           (contact.empty() ? "" : " contactPoint=\"" + contact + "\"") + "/>";
}

std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.12g", value);
    return text;
}

std::string plan(const glm::dvec2& from, double headingRad, double lengthM, double curvature)
{
    const std::string shape = curvature == 0.0 ? "<line/>" : "<arc curvature=\"" + number(curvature) + "\"/>";
    return "<planView><geometry s=\"0\" x=\"" + number(from.x) + "\" y=\"" + number(from.y) + "\" hdg=\"" +
           number(headingRad) + "\" length=\"" + number(lengthM) + "\">" + shape + "</geometry></planView>";
}

glm::dvec2 towards(int arm)
{
    const double angle = 0.5 * std::numbers::pi * arm;
    return {std::cos(angle), std::sin(angle)};
}

/// A lane of one side: -1 on the right. The lanes before and behind it, where its road has others.
std::string laneText(int id, const std::string& links = "")
{
    return "<lane id=\"" + std::to_string(id) + "\" type=\"driving\" level=\"false\">" +
           (links.empty() ? "" : "<link>" + links + "</link>") + roadtexts::kWidth + "</lane>";
}

std::string lanesText(const std::string& left, const std::string& right)
{
    return "<lanes><laneSection s=\"0\">" + (left.empty() ? "" : "<left>" + left + "</left>") +
           "<center><lane id=\"0\" type=\"none\" level=\"false\"/></center><right>" + right +
           "</right></laneSection></lanes>";
}

std::string roadText(int id, double lengthM, const std::string& links, const std::string& rest, int junction)
{
    return "<road id=\"" + std::to_string(id) + "\" length=\"" + number(lengthM) + "\" junction=\"" +
           std::to_string(junction) + "\"><link>" + links + "</link>" + rest + "</road>\n";
}

const std::string kTownLimit = R"(<type s="0" type="town"><speed max="50" unit="km/h"/></type>)";

/// Arms 1 to 4 to the east, north, west and south; loops 5 and 6; connecting roads from 11 on. `signs`: of an
/// arm, facing its traffic before the junction.
std::string crossingText(const std::string& eastSign = "", const std::string& priorities = "")
{
    std::string text;
    const double pi = std::numbers::pi, loopM = 1.5 * pi * (kHalfM + kArmM);
    for (int arm = 0; arm < 4; ++arm)
    {
        const int loop = arm < 2 ? 5 : 6;
        const bool entersLoop = arm % 2 == 0; // east and west; the others are its ends
        const std::string ahead = std::string("<successor id=\"") + (entersLoop ? "-1" : "1") + "\"/>";
        const std::string back = std::string("<successor id=\"") + (entersLoop ? "1" : "-1") + "\"/>";
        text += roadText(arm + 1, kArmM,
                         link("predecessor", "junction", 100) +
                             link("successor", "road", loop, entersLoop ? "start" : "end"),
                         kTownLimit + plan(kHalfM * towards(arm), 0.5 * pi * arm, kArmM, 0.0) +
                             lanesText(laneText(1, back), laneText(-1, ahead)) +
                             (arm == 0 && !eastSign.empty() ? "<signals>" + eastSign + "</signals>" : ""),
                         -1);
    }
    for (int loop = 0; loop < 2; ++loop)
    {
        const int from = 2 * loop, to = from + 1;
        text += roadText(
            5 + loop, loopM,
            link("predecessor", "road", from + 1, "end") + link("successor", "road", to + 1, "end"),
            kTownLimit +
                plan((kHalfM + kArmM) * towards(from), 0.5 * pi * from, loopM, 1.0 / (kHalfM + kArmM)) +
                lanesText(laneText(1, R"(<predecessor id="1"/><successor id="-1"/>)"),
                          laneText(-1, R"(<predecessor id="-1"/><successor id="1"/>)")),
            -1);
    }
    std::string connections;
    int id = 11;
    for (int from = 0; from < 4; ++from)
        for (int turn = 1; turn < 4; ++turn, ++id)
        {
            const int to = (from + turn) % 4; // 1: to the right, 2: straight on, 3: to the left
            const double curvature = turn == 2 ? 0.0 : turn == 1 ? -1.0 / kHalfM : 1.0 / kHalfM;
            const double lengthM = turn == 2 ? 2.0 * kHalfM : 0.5 * pi * kHalfM;
            text += roadText(
                id, lengthM,
                link("predecessor", "road", from + 1, "start") + link("successor", "road", to + 1, "start"),
                kTownLimit + plan(kHalfM * towards(from), 0.5 * pi * from + pi, lengthM, curvature) +
                    lanesText("", laneText(-1, R"(<predecessor id="1"/><successor id="-1"/>)")),
                100);
            connections += "<connection id=\"" + std::to_string(id) + "\" incomingRoad=\"" +
                           std::to_string(from + 1) + "\" connectingRoad=\"" + std::to_string(id) +
                           "\" contactPoint=\"start\"><laneLink from=\"1\" to=\"-1\"/></connection>";
        }
    return roadtexts::network(text + "<junction id=\"100\" name=\"\">" + connections + priorities +
                              "</junction>");
}

std::shared_ptr<const RoadScene> crossing(const std::string& text = crossingText())
{
    return std::make_shared<const RoadScene>(roadtexts::sound(text));
}

/// Somebody who stands at a place, with traffic around it.
Scenario trafficAround(const glm::dvec2& place, double perKm, double radiusM)
{
    Scenario scenario;
    scenario.entities.push_back({{}, "Ego", defaultVehicle("car")});
    TeleportAction teleport;
    teleport.position = WorldPosition{{}, place.x, place.y, 0.0, Orientation{0.0, {}, {}}};
    scenario.storyboard.init.privates.push_back({{}, "Ego", {teleport}});
    addTraffic(scenario, "Ego", {perKm, radiusM});
    return scenario;
}

std::unique_ptr<ScenarioPlayer> playerOf(Scenario scenario, std::shared_ptr<const RoadScene> roads,
                                         std::uint64_t seed = 0, int stepsPerSecond = 60)
{
    PlayerOptions options;
    options.clock = FixedClock(stepsPerSecond);
    options.seed = seed;
    options.roads = std::move(roads);
    auto player = ScenarioPlayer::create(std::move(scenario), std::move(options));
    EXPECT_TRUE(player) << player.error().message();
    return player ? std::move(*player) : nullptr;
}

/// What was seen of the traffic.
struct Watched
{
    int collisions = 0; ///< pairs that began to touch
    double longestStandS = 0.0;
    double drivenM = 0.0; ///< by all
    std::size_t most = 0, least = 1000;
    double fastestMps = 0.0;
};

Watched watch(ScenarioPlayer& player, double untilS)
{
    Watched seen;
    const auto count = player.entities().size();
    std::vector<double> standsS(count, 0.0);
    std::vector<std::vector<int>> touching(count);
    while (player.timeS() < untilS)
    {
        player.step();
        std::size_t present = 0;
        for (std::size_t i = 1; i < count; ++i)
        {
            const EntityState& state = player.entities()[i];
            if (!state.isPresent) continue;
            ++present;
            standsS[i] = state.speedMps < 0.1 ? standsS[i] + player.clock().stepS() : 0.0;
            seen.longestStandS = std::max(seen.longestStandS, standsS[i]);
            seen.drivenM += state.speedMps * player.clock().stepS();
            seen.fastestMps = std::max(seen.fastestMps, state.speedMps);
            for (const int other : state.collidesWith)
                if (std::find(touching[i].begin(), touching[i].end(), other) == touching[i].end())
                    ++seen.collisions;
            touching[i] = state.collidesWith;
        }
        seen.most = std::max(seen.most, present);
        seen.least = std::min(seen.least, present);
    }
    return seen;
}

TEST(RuledTraffic, HasNoCollisionAndNoJamInAnHour)
{
    const auto player = playerOf(trafficAround({300.0, -300.0}, 15.0, 2000.0), crossing(), 0, 30);
    ASSERT_TRUE(player);
    const Watched seen = watch(*player, 3600.0);
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_LT(seen.longestStandS, 120.0);
    EXPECT_GE(seen.least, 20u);
    EXPECT_GT(seen.drivenM / static_cast<double>(seen.most), 3600.0 * 5.0) << "m for each vehicle";
    EXPECT_LE(seen.fastestMps, 50.0 / 3.6 + 0.1);
    RecordProperty("standsS", std::to_string(seen.longestStandS));
}

/// The mutation of the test above: drivers who do not give way.
TEST(RuledTraffic, CollidesWhereNobodyGivesWay)
{
    Scenario scenario = trafficAround({300.0, -300.0}, 15.0, 2000.0);
    auto& action = std::get<TrafficAction>(scenario.storyboard.init.globals.back());
    for (TrafficMix::Driver& driver : std::get<TrafficSwarm>(action.content).mix.drivers)
        driver.controller.properties.values.emplace_back("givesWay", "false");
    const auto player = playerOf(std::move(scenario), crossing(), 0, 30);
    ASSERT_TRUE(player);
    EXPECT_GT(watch(*player, 300.0).collisions, 0);
}

TEST(RuledTraffic, StandsBehindAPersonWhoStands)
{
    // On the lane that leads from the east to the crossing, 45 m before it, looking along its traffic.
    Scenario scenario = trafficAround({60.0, 1.75}, 15.0, 2000.0);
    auto& teleport = std::get<TeleportAction>(scenario.storyboard.init.privates.front().actions.front());
    std::get<WorldPosition>(teleport.position).orientation.headingRad = std::numbers::pi;
    const auto player = playerOf(std::move(scenario), crossing());
    ASSERT_TRUE(player);
    const Watched seen = watch(*player, 120.0);
    EXPECT_EQ(seen.collisions, 0);
    double nearestM = 1e9; // behind it, where those stand that came to it
    for (std::size_t i = 1; i < player->entities().size(); ++i)
    {
        const EntityState& state = player->entities()[i];
        if (state.isPresent && std::fabs(state.position.y - 1.75) < 0.5 && state.position.x > 60.0)
            nearestM = std::min(nearestM, state.position.x - 60.0);
    }
    // From rear axle to rear axle: a front of 3.55 m or 4.42 m, a tail of 0.95 m, 2 m between them.
    EXPECT_GT(nearestM, 5.5);
    EXPECT_LT(nearestM, 8.5);
}

TEST(RuledTraffic, IsTheSameInEveryRunAndAnotherWithAnotherSeed)
{
    const auto placesOf = [](std::uint64_t seed)
    {
        const auto player = playerOf(trafficAround({300.0, -300.0}, 15.0, 2000.0), crossing(), seed);
        std::vector<double> places;
        if (!player) return places;
        (void)watch(*player, 20.0);
        for (const EntityState& state : player->entities())
            for (const double place : {state.position.x, state.position.y, state.speedMps})
                places.push_back(place);
        return places;
    };
    const std::vector<double> once = placesOf(1);
    EXPECT_EQ(once, placesOf(1));
    EXPECT_NE(once, placesOf(2));
}

TEST(RuledTraffic, AppearsAndLeavesFarFromThePersonAlone)
{
    constexpr double kRadiusM = 150.0;
    const auto player = playerOf(trafficAround({0.0, 60.0}, 20.0, kRadiusM), crossing());
    ASSERT_TRUE(player);
    const auto apart = [&](const EntityState& state)
    { return glm::length(glm::dvec2(state.position) - glm::dvec2(0.0, 60.0)); };
    std::vector<EntityState> before = player->entities();
    int appeared = 0, left = 0;
    while (player->timeS() < 120.0)
    {
        player->step();
        const std::vector<EntityState>& now = player->entities();
        for (std::size_t i = 1; i < now.size(); ++i)
        {
            if (now[i].isPresent == before[i].isPresent) continue;
            ++(now[i].isPresent ? appeared : left);
            EXPECT_GE(apart(now[i].isPresent ? now[i] : before[i]),
                      now[i].isPresent ? SessionTraffic::kAppearShare * kRadiusM - 1.0 : kRadiusM - 1.0);
        }
        before = now;
    }
    EXPECT_GT(appeared, 3);
    EXPECT_GT(left, 3);
}

TEST(TrafficDensity, IsAWordOrVehiclesAKilometre)
{
    EXPECT_EQ(trafficDensity("none"), 0.0);
    EXPECT_EQ(trafficDensity("light"), 4.0);
    EXPECT_EQ(trafficDensity("medium"), 10.0);
    EXPECT_EQ(trafficDensity("dense"), 25.0);
    EXPECT_EQ(trafficDensity("7.5"), 7.5);
    for (const char* const wrong : {"", "much", "-1", "61", "nan", "5 km"})
        EXPECT_FALSE(trafficDensity(wrong)) << wrong;
}

/// The lane through the crossing from an arm to another one: 0 to 3, east, north, west, south.
JunctionLane through(const RoadScene& roads, int from, int to)
{
    const int turn = (to - from + 4) % 4;
    return {roads.network().roadIndex(std::to_string(11 + 3 * from + turn - 1)), -1, true};
}

TEST(JunctionTable, LetsWhoComesFromTheRightGoFirst)
{
    const auto roads = crossing();
    JunctionTable table(*roads);
    const JunctionLane fromEast = through(*roads, 0, 2), fromNorth = through(*roads, 1, 3);
    EXPECT_TRUE(table.goesBefore(fromNorth, fromEast)) << "whoever drives west has the north on the right";
    EXPECT_FALSE(table.goesBefore(fromEast, fromNorth));
    const JunctionLane leftFromWest = through(*roads, 2, 1);
    EXPECT_TRUE(table.goesBefore(fromEast, leftFromWest)) << "it crosses the way of the other";
    EXPECT_FALSE(table.goesBefore(leftFromWest, fromEast));
}

TEST(JunctionTable, HoldsPrioritiesAndSignsHigher)
{
    const auto ruled = crossing(crossingText("", R"(<priority high="1" low="2"/>)"));
    JunctionTable byPriority(*ruled);
    EXPECT_TRUE(byPriority.goesBefore(through(*ruled, 0, 2), through(*ruled, 1, 3)));
    EXPECT_FALSE(byPriority.goesBefore(through(*ruled, 1, 3), through(*ruled, 0, 2)));
    // To give way, faced by whoever drives to the crossing, against s.
    const auto signedNetwork = crossing(crossingText(
        R"(<signal s="2" t="5" id="1" name="" dynamic="no" orientation="-" country="DE" type="205" subtype="-1" zOffset="2" value="-1" height="0.9" width="0.9"/>)"));
    JunctionTable bySigns(*signedNetwork);
    const JunctionLane fromEast = through(*signedNetwork, 0, 2);
    EXPECT_TRUE(bySigns.goesBefore(through(*signedNetwork, 3, 1), fromEast)) << "it comes from the left";
    EXPECT_FALSE(bySigns.goesBefore(fromEast, through(*signedNetwork, 3, 1)));
}

TEST(JunctionTable, KnowsWhichLanesMeet)
{
    const auto roads = crossing();
    JunctionTable table(*roads);
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 1, 3)));
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 2, 1)));
    EXPECT_TRUE(table.conflict(through(*roads, 0, 2), through(*roads, 1, 2))) << "both leave to the west";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 2), through(*roads, 2, 0))) << "beside each other";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 1), through(*roads, 1, 2))) << "both turn to the right";
    EXPECT_FALSE(table.conflict(through(*roads, 0, 2), through(*roads, 0, 3))) << "one follows the other";
    const LaneConflict* const crossed = table.conflict(through(*roads, 0, 2), through(*roads, 1, 3));
    // The lanes cross 16.75 m behind the begin of the first; the front of a vehicle, with some room 4.6 m
    // before its rear axle, comes to the side of the other, half as wide as 2.1 m, before that.
    ASSERT_TRUE(crossed);
    EXPECT_NEAR(crossed->ownFromM, 16.75 - 1.05 - 4.6, 1.1);
    EXPECT_NEAR(crossed->ownToM, 16.75 + 1.05 + 1.3, 1.1);
}

/// Three one-way arcs around the origin, and three arms that come to them. The lines of the junctions are
/// rough; who goes before whom is not a matter of millimetres.
std::string ringText()
{
    constexpr double kRadiusM = 20.0, kGapRad = 0.35;
    const double part = 2.0 * std::numbers::pi / 3.0, arcM = kRadiusM * (part - kGapRad);
    const auto at = [](double angle) { return kRadiusM * glm::dvec2(std::cos(angle), std::sin(angle)); };
    const double pi = std::numbers::pi;
    std::string text, junctions;
    const std::string one = lanesText("", laneText(-1));
    for (int i = 0; i < 3; ++i)
    {
        const int junction = 100 + i, next = 100 + (i + 1) % 3;
        const double begin = part * i + 0.5 * kGapRad, middle = part * i;
        text += roadText(1 + i, arcM,
                         link("predecessor", "junction", junction) + link("successor", "junction", next),
                         kTownLimit + plan(at(begin), begin + 0.5 * pi, arcM, 1.0 / kRadiusM) + one, -1);
        text += roadText(11 + i, 100.0, link("predecessor", "junction", junction),
                         kTownLimit + plan(1.3 * at(middle), middle, 100.0, 0.0) +
                             lanesText(laneText(1), laneText(-1)),
                         -1);
        const int before = 1 + (i + 2) % 3;
        text += roadText(
            21 + i, kRadiusM * kGapRad,
            link("predecessor", "road", before, "end") + link("successor", "road", 1 + i, "start"),
            plan(at(begin - kGapRad), begin - kGapRad + 0.5 * pi, kRadiusM * kGapRad, 1.0 / kRadiusM) + one,
            junction);
        text +=
            roadText(31 + i, 8.0,
                     link("predecessor", "road", 11 + i, "start") + link("successor", "road", 1 + i, "start"),
                     plan(1.3 * at(middle), middle + pi, 8.0, 0.0) + one, junction);
        const auto connection = [](int id, int from, int over, int lane)
        {
            return "<connection id=\"" + std::to_string(id) + "\" incomingRoad=\"" + std::to_string(from) +
                   "\" connectingRoad=\"" + std::to_string(over) +
                   "\" contactPoint=\"start\"><laneLink from=\"" + std::to_string(lane) +
                   "\" to=\"-1\"/></connection>";
        };
        junctions += "<junction id=\"" + std::to_string(junction) + "\" name=\"\">" +
                     connection(0, before, 21 + i, -1) + connection(1, 11 + i, 31 + i, 1) + "</junction>";
    }
    return roadtexts::network(text + junctions);
}

TEST(JunctionTable, LetsWhoIsInARoundaboutGoFirst)
{
    const auto roads = crossing(ringText());
    JunctionTable table(*roads);
    const JunctionLane inRing{roads->network().roadIndex("21"), -1, true};
    const JunctionLane fromArm{roads->network().roadIndex("31"), -1, true};
    EXPECT_TRUE(table.goesBefore(inRing, fromArm)) << "though the other comes from the right";
    EXPECT_FALSE(table.goesBefore(fromArm, inRing));
}

} // namespace
} // namespace simulation
