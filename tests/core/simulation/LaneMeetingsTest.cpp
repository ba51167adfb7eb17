// SPDX-License-Identifier: Apache-2.0
// Where lanes have no room beside each other, and what those do who meet there.
#include "simulation/road/LaneMeetings.h"

#include <numbers>

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "TrafficNetworks.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

constexpr double kStraightM = 60.0;

double bendM(double radiusM)
{
    return std::numbers::pi * radiusM;
}

/// A street of two lanes that turns round in a bend: 60 m straight, half a circle, 60 m straight.
std::shared_ptr<const RoadScene> hairpin(double radiusM)
{
    const auto piece =
        [](double s, const glm::dvec2& from, double heading, double lengthM, const std::string& shape)
    {
        return "<geometry s=\"" + number(s) + "\" x=\"" + number(from.x) + "\" y=\"" + number(from.y) +
               "\" hdg=\"" + number(heading) + "\" length=\"" + number(lengthM) + "\">" + shape +
               "</geometry>";
    };
    const double arcM = bendM(radiusM);
    const std::string shape =
        piece(0.0, {0.0, 0.0}, 0.0, kStraightM, "<line/>") +
        piece(kStraightM, {kStraightM, 0.0}, 0.0, arcM,
              "<arc curvature=\"" + number(1.0 / radiusM) + "\"/>") +
        piece(kStraightM + arcM, {kStraightM, 2.0 * radiusM}, std::numbers::pi, kStraightM, "<line/>");
    return crossing(roadtexts::network(roadText(
        1, 2.0 * kStraightM + arcM, "",
        kTownLimit + "<planView>" + shape + "</planView>" + lanesText(laneText(1), laneText(-1)), -1)));
}

TEST(LaneMeetings, ANarrowBendIsOnePlaceForBothDirections)
{
    const auto roads = hairpin(6.0);
    LaneMeetings meetings(*roads);
    const JunctionLane outer{0, -1, true}, inner{0, 1, false};
    for (const JunctionLane& lane : {outer, inner})
    {
        ASSERT_EQ(meetings.narrowOn(lane).size(), 1U);
        EXPECT_GT(meetings.narrowOn(lane)[0].fromM, kStraightM - 10.0);
        EXPECT_LT(meetings.narrowOn(lane)[0].toM, kStraightM + bendM(6.0 + 1.75) + 10.0);
        ASSERT_EQ(meetings.metBy(lane).size(), 1U);
    }
    EXPECT_EQ(meetings.metBy(outer)[0].first, inner);
    // The mutation: a wide bend has room for both.
    const auto wide = hairpin(30.0);
    LaneMeetings apart(*wide);
    EXPECT_TRUE(apart.narrowOn(outer).empty());
    EXPECT_TRUE(apart.narrowOn(inner).empty());
}

/// What came of two who met in a narrow bend.
struct MetInBend
{
    bool haveTouched = false, havePassed = false;
};

MetInBend meetInBend(const std::string& givesWay)
{
    constexpr double kTightM = 2.5;
    ScenarioText text;
    const double lengthM = 2.0 * kStraightM + bendM(kTightM);
    const std::string places[] = {roadplay::onLane(15.0, -1), roadplay::onLane(lengthM - 15.0, 1)};
    text.privates = teleport(R"(<WorldPosition x="0" y="200"/>)");
    for (int i = 0; i < 2; ++i)
    {
        const std::string name = "Other" + std::to_string(i);
        text.entities +=
            "<ScenarioObject name=\"" + name + "\">" + kCar +
            "<ObjectController><Controller name=\"IntelligentDriver\"><Properties>"
            "<Property name=\"keepsRules\" value=\"true\"/><Property name=\"givesWay\" value=\"" +
            givesWay + "\"/></Properties></Controller></ObjectController></ScenarioObject>";
        text.globals += "<Private entityRef=\"" + name + "\">" + places[i] + speedAction(7.0) +
                        "<PrivateAction><ActivateControllerAction longitudinal=\"true\" "
                        "lateral=\"false\"/></PrivateAction></Private>";
    }
    const auto player = roadplay::begun(text, hairpin(kTightM));
    MetInBend met;
    while (player && player->timeS() < 60.0)
    {
        player->step();
        met.haveTouched = met.haveTouched || !player->entities()[1].collidesWith.empty();
    }
    if (!player) return met;
    const auto& one = player->entities()[1].place;
    const auto& two = player->entities()[2].place;
    met.havePassed = one && two && one->s > kStraightM + bendM(kTightM) + 20.0 && two->s < kStraightM - 20.0;
    return met;
}

TEST(LaneMeetings, OneOfTwoWaitsBeforeANarrowBend)
{
    const MetInBend met = meetInBend("true");
    EXPECT_FALSE(met.haveTouched);
    EXPECT_TRUE(met.havePassed);
    // The mutation: who does not ask touches the other one, or stands before it for ever.
    const MetInBend unasked = meetInBend("false");
    EXPECT_TRUE(unasked.haveTouched || !unasked.havePassed);
}

/// Two lanes of a junction are in its own table; a lane and those that go on from it follow one another.
TEST(LaneMeetings, LeavesAloneWhoFollowsAndWhatTheJunctionKnows)
{
    const auto roads = crossing();
    LaneMeetings meetings(*roads);
    const JunctionLane west = through(*roads, 0, 2);
    for (const auto& [lane, conflicts] : meetings.metBy(west))
    {
        EXPECT_NE(roads->network().roads[static_cast<std::size_t>(lane.road)].junction,
                  roads->network().roads[static_cast<std::size_t>(west.road)].junction);
        EXPECT_FALSE(conflicts.empty());
    }
    EXPECT_TRUE(meetings.narrowOn({roads->network().roadIndex("1"), -1, true}).empty())
        << "arms of a wide crossing are clear of those who turn";
}

} // namespace
} // namespace simulation
