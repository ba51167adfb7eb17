// SPDX-License-Identifier: Apache-2.0
// Traffic lights that nobody controls, and traffic at them: a crossing whose four arms have lights, and a
// queue on a straight road.
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <foundation/Angle.h>
#include <gtest/gtest.h>

#include "TrafficNetworks.h"
#include "TrafficWatch.h"
#include "simulation/road/LightApproaches.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

std::shared_ptr<const RoadScene> litCrossing()
{
    return crossing(crossingText(lightsOnArms()));
}

std::string stateIn(const SignalPhase& phase, const std::string& light)
{
    for (const auto& [signal, state] : phase.states)
        if (signal == light) return state;
    return "";
}

TEST(SignalProgrammes, GiveGreenToTwoThatFaceEachOther)
{
    const auto roads = litCrossing();
    EXPECT_TRUE(hasTrafficLights(roads->network()));
    const auto programmes = signalProgrammes(*roads);
    ASSERT_EQ(programmes.size(), 1U);
    EXPECT_EQ(programmes[0].name, "lights of junction 100");
    std::set<std::string> greens;
    double cycleS = 0.0;
    for (const SignalPhase& phase : programmes[0].phases)
    {
        ASSERT_EQ(phase.states.size(), 4U) << phase.name;
        const std::string east = stateIn(phase, "201"), north = stateIn(phase, "202");
        EXPECT_EQ(east, stateIn(phase, "203")) << phase.name;
        EXPECT_EQ(north, stateIn(phase, "204")) << phase.name;
        EXPECT_TRUE(east == "red" || north == "red") << phase.name;
        if (east == "green") greens.insert("east");
        if (north == "green") greens.insert("north");
        cycleS += phase.durationS;
    }
    EXPECT_EQ(greens.size(), 2U);
    EXPECT_NEAR(cycleS, 60.0, 1.0);
}

/// What the sources say for 50 km/h: 3 s of yellow, 1 s of red and amber. Who turned left from the east last
/// has crossed its line 2 s after green, and clears at 7 m/s where it meets who comes straight from the
/// north: 5 to 6 s from green to green.
TEST(SignalProgrammes, KeepTheTimesBetweenGreens)
{
    const auto programmes = signalProgrammes(*litCrossing());
    ASSERT_EQ(programmes.size(), 1U);
    double sinceGreenS = 0.0;
    int changes = 0;
    for (const SignalPhase& phase : programmes[0].phases)
    {
        const std::string word = phase.name.substr(0, phase.name.find(' '));
        const double greenS = programmes[0].phases.front().durationS;
        const std::map<std::string, double> durations{{"green", greenS}, {"yellow", 3.0}, {"attention", 1.0}};
        if (const auto given = durations.find(word); given != durations.end())
        {
            EXPECT_EQ(phase.durationS, given->second) << phase.name;
        }
        sinceGreenS = word == "green" ? 0.0 : sinceGreenS + phase.durationS;
        if (word != "attention") continue;
        ++changes;
        EXPECT_GE(sinceGreenS, 5.0);
        EXPECT_LE(sinceGreenS, 6.0);
    }
    EXPECT_EQ(changes, 2);
}

TEST(SignalProgrammes, GiveFasterRoadsMoreYellow)
{
    std::string text = crossingText(lightsOnArms());
    for (std::size_t at = 0; (at = text.find("max=\"50\"", at)) != std::string::npos; ++at)
        text.replace(at, 8, "max=\"70\"");
    const auto programmes = signalProgrammes(*crossing(text));
    ASSERT_EQ(programmes.size(), 1U);
    for (const SignalPhase& phase : programmes[0].phases)
    {
        const bool isYellow = phase.name.starts_with("yellow");
        EXPECT_TRUE(!isYellow || phase.durationS == 5.0) << phase.durationS;
    }
}

/// A light at 300 m of a road of 2 km.
std::string straightWithLight()
{
    return roadtexts::network(roadtexts::road(
        "1", 2000.0,
        kTownLimit + roadtexts::straightPlan(2000.0) + roadtexts::twoLanes() +
            R"(<signals><signal s="300" t="-4" id="7" name="" dynamic="yes" orientation="+" zOffset="3" type="1000001" subtype="-1" country="OpenDRIVE" value="-1"/></signals>)"));
}

TEST(SignalProgrammes, LetPeopleOnFootCrossBetweenJunctions)
{
    const auto programmes = signalProgrammes(*crossing(straightWithLight()));
    ASSERT_EQ(programmes.size(), 1U);
    EXPECT_EQ(programmes[0].name, "light 7");
    std::map<std::string, double> secondsOf;
    for (const SignalPhase& phase : programmes[0].phases)
        secondsOf[stateIn(phase, "7")] += phase.durationS;
    EXPECT_GE(secondsOf["red"], 15.0);
    EXPECT_GE(secondsOf["green"], 30.0);
    EXPECT_EQ(secondsOf["yellow"], 3.0);
    EXPECT_EQ(secondsOf["attention"], 1.0);
}

TEST(SignalProgrammes, LeaveSignsAlone)
{
    EXPECT_FALSE(hasTrafficLights(crossing()->network()));
    EXPECT_TRUE(signalProgrammes(*crossing()).empty());
}

/// Counts who crosses the lines of the arms at red. `shift`: looks at the light of another arm.
class RedRunners
{
public:
    RedRunners(const ScenarioPlayer& player, int shift)
        : _player(player), _shift(shift), _beforeM(player.entities().size(), std::array<double, 4>{})
    {
    }

    void look()
    {
        constexpr double kLineM = kHalfM + 2.0;
        for (std::size_t i = 1; i < _player.entities().size(); ++i)
        {
            const EntityState& state = _player.entities()[i];
            const BoundingBox& box = _player.scenario().entities[i].box();
            const double heading = foundation::radiansOf(state.headingDeg);
            const glm::dvec2 ahead(std::cos(heading), std::sin(heading));
            const glm::dvec2 front = glm::dvec2(state.position) + (box.centre.x + 0.5 * box.lengthM) * ahead;
            for (int arm = 0; arm < 4; ++arm)
            {
                const glm::dvec2 out = towards(arm), left(-out.y, out.x);
                double& beforeM = _beforeM[i][static_cast<std::size_t>(arm)];
                const double atM = glm::dot(front, out), besideM = glm::dot(front, left);
                const bool comes = glm::dot(ahead, out) < -0.9 && besideM > 0.5 && besideM < 3.0;
                const bool crosses = state.isPresent && comes && beforeM > kLineM && atM <= kLineM;
                beforeM = state.isPresent && comes ? atM : 0.0;
                if (!crosses) continue;
                ++passed;
                const auto& states = _player.signalStates();
                if (states.at(std::to_string(201 + (arm + _shift) % 4)) == "red") ++atRed;
            }
        }
    }

    int passed = 0, atRed = 0;

private:
    const ScenarioPlayer& _player;
    int _shift;
    std::vector<std::array<double, 4>> _beforeM;
};

void expectOrder(double untilS, double mostStandS)
{
    const auto player = playerOf(trafficAround({300.0, -300.0}, 15.0, 2000.0), litCrossing(), 0, 30);
    ASSERT_TRUE(player);
    RedRunners runners(*player, 0), elsewhere(*player, 1);
    const Watched seen = watch(*player, untilS,
                               [&]
                               {
                                   runners.look();
                                   elsewhere.look();
                               });
    EXPECT_EQ(seen.collisions, 0);
    EXPECT_EQ(runners.atRed, 0);
    EXPECT_GT(runners.passed, untilS / 12.0);
    EXPECT_GT(elsewhere.atRed, runners.passed / 2) << "the mutation: by another light they all run red";
    EXPECT_LT(seen.longestStandS, mostStandS);
    EXPECT_GE(seen.least, 20u);
    testing::Test::RecordProperty("standsS", std::to_string(seen.longestStandS));
    testing::Test::RecordProperty("passed", std::to_string(runners.passed));
}

TEST(LitCrossing, NobodyRunsRedOrCollidesInAMinute)
{
    expectOrder(90.0, 120.0);
}

/// Two cycles and a half: on one lane those behind who turns left wait with it, through its red, too.
TEST(LitCrossingHour, NobodyRunsRedOrCollidesAndNoneStandsForLong)
{
    expectOrder(3600.0, 150.0);
}

/// The mutation: who turns left does not wait for those who come the other way, whose light is green, too.
TEST(LitCrossing, HasCollisionsWhereNobodyGivesWay)
{
    const auto player =
        playerOf(withoutGivingWay(trafficAround({300.0, -300.0}, 15.0, 2000.0)), litCrossing(), 0, 30);
    ASSERT_TRUE(player);
    EXPECT_GT(watch(*player, 300.0).collisions, 0);
}

/// A queue of so many vehicles before the light of the straight road, driven as the traffic of a session is.
Scenario queueAtLight(int count)
{
    constexpr double kApartM = 8.0;
    const Scenario session = trafficAround({0.0, 0.0}, 10.0, 500.0);
    const auto& swarm =
        std::get<TrafficSwarm>(std::get<TrafficAction>(session.storyboard.init.globals.back()).content);
    Scenario scenario;
    for (int i = 0; i < count; ++i)
    {
        const std::string name = "Queued" + std::to_string(i);
        scenario.entities.push_back({{}, name, defaultVehicle("car")});
        scenario.entities.back().controllers = {
            swarm.mix.drivers[static_cast<std::size_t>(i) % swarm.mix.drivers.size()].controller};
        TeleportAction teleport;
        teleport.position = LanePosition{{}, "1", -1, 294.0 - kApartM * i, 0.0, {}};
        ActivateControllerAction activate;
        activate.longitudinal = true;
        scenario.storyboard.init.privates.push_back({{}, name, {teleport, activate}});
    }
    return scenario;
}

/// From the fourth on, by which time a queue flows. Source: *Highway Capacity Manual*, 6th edition, 2016,
/// chapter 19: 1900 passenger cars an hour of green and lane.
TEST(LitQueue, FlowsAsTheHighwayCapacityManualHasIt)
{
    constexpr int kQueued = 15;
    const auto player = playerOf(queueAtLight(kQueued), crossing(straightWithLight()), 0, 60);
    ASSERT_TRUE(player);
    std::vector<double> passedS;
    while (player->timeS() < 60.0 && passedS.size() < kQueued)
    {
        player->step();
        const auto& next = player->entities()[passedS.size()];
        const BoundingBox& box = player->scenario().entities[passedS.size()].box();
        if (next.position.x + box.centre.x + 0.5 * box.lengthM > 300.0) passedS.push_back(player->timeS());
    }
    ASSERT_EQ(passedS.size(), std::size_t(kQueued)) << "one green is enough";
    const double headwayS = (passedS.back() - passedS[3]) / (kQueued - 4);
    const double flow = 3600.0 / headwayS;
    RecordProperty("vehiclesAnHour", std::to_string(flow));
    EXPECT_NEAR(flow, 1900.0, 0.2 * 1900.0);
}

} // namespace
} // namespace simulation
