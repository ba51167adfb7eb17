// SPDX-License-Identifier: Apache-2.0
// Who is let into a junction where vehicles stand: causes of jams, each on a small network with its mutation.
#include "simulation/player/way/JunctionKeeper.h"

#include <gtest/gtest.h>

#include "RoadPlay.h"
#include "TrafficNetworks.h"

namespace simulation
{
namespace
{

using namespace trafficnetworks;

constexpr double kLongS = 60.0;

/// Vehicle 1 wants to go straight on from the south, vehicle 2 has waited for long to go from the east.
/// `frontM`: of vehicle 1 in another lane, from where that begins.
struct TwoWait
{
    explicit TwoWait(double frontM) : roads(crossing()), keeper(*roads)
    {
        JunctionApproach& one = keeper.of(1);
        one.standsS = 2.0;
        one.claims = {{through(*roads, 0, 1), 0.0, frontM, frontM - 4.5, true},
                      {through(*roads, 3, 1), 10.0, -2.0, -6.5}};
        JunctionApproach& two = keeper.of(2);
        two.standsS = kLongS;
        two.claims = {{through(*roads, 0, 2), 0.0, -3.0, -7.5}};
        for (JunctionApproach* const of : {&one, &two})
            for (JunctionClaim& claim : of->claims)
                claim.junction = keeper.table().junctionOf(claim.lane.road);
        one.claims.back().isAsked = two.claims.back().isAsked = true;
    }

    int inTheWayOf(int vehicle) { return keeper.inTheWay(vehicle, keeper.of(vehicle).claims.back()); }

    std::shared_ptr<const RoadScene> roads;
    JunctionKeeper keeper;
};

TEST(JunctionKeeper, WhoStandsInAJunctionGoesBeforeWhoHasWaitedOutside)
{
    TwoWait inside(3.0);
    EXPECT_EQ(inside.inTheWayOf(1), -1);
    EXPECT_EQ(inside.inTheWayOf(2), 1);
    // The mutation: before the junction it waits for the one that has waited longer.
    TwoWait before(-5.0);
    EXPECT_EQ(before.inTheWayOf(1), 2);
    EXPECT_EQ(before.inTheWayOf(2), -1);
}

/// Each of both waits for the other one, which has been let in and cannot go.
TEST(JunctionKeeper, OneOfThoseWhoWaitForEachOtherGoes)
{
    for (const double standsS : {kLongS, 0.0})
    {
        TwoWait knot(-5.0);
        knot.keeper.of(1).standsS = standsS;
        knot.keeper.of(1).waitsFor = 2;
        knot.keeper.of(2).waitsFor = 1;
        JunctionClaim& held = knot.keeper.of(2).claims.back();
        held.isHeld = true;
        EXPECT_EQ(knot.keeper.isInKnot(1), standsS > 0.0);
        EXPECT_EQ(knot.keeper.inTheWay(1, knot.keeper.of(1).claims.back(), knot.keeper.isInKnot(1)),
                  standsS > 0.0 ? -1 : 2);
        EXPECT_EQ(held.isHeld, standsS == 0.0) << "it asks again";
    }
}

TEST(JunctionKeeper, ForgetsWhoLooksNoLonger)
{
    TwoWait wait(-5.0);
    wait.keeper.of(1).seenS = 10.0;
    wait.keeper.of(2).seenS = 9.0;
    wait.keeper.setTime(10.0);
    EXPECT_TRUE(wait.keeper.isKept(1));
    EXPECT_FALSE(wait.keeper.isKept(2)) << "it was deleted, or a person drives it";
    EXPECT_EQ(wait.inTheWayOf(1), -1);
}

/// The x of the front of the second of two cars that come from the east, when they have stood for a while
/// behind a car that stands on the lane to the west. `standsAtM`: from the crossing.
double frontOfSecondM(double standsAtM)
{
    ScenarioText text;
    text.privates = roadplay::onLane(standsAtM, -1, "3");
    for (int i = 0; i < 2; ++i)
    {
        const std::string name = "Other" + std::to_string(i);
        text.entities += "<ScenarioObject name=\"" + name + "\">" + kCar +
                         "<ObjectController><Controller name=\"IntelligentDriver\"><Properties>"
                         "<Property name=\"keepsRules\" value=\"true\"/></Properties></Controller>"
                         "</ObjectController></ScenarioObject>";
        text.globals += "<Private entityRef=\"" + name + "\">" + roadplay::onLane(40.0 + 12.0 * i, 1, "1") +
                        speedAction(8.0) +
                        "<PrivateAction><ActivateControllerAction longitudinal=\"true\" "
                        "lateral=\"false\"/></PrivateAction></Private>";
    }
    const auto player = roadplay::played(text, 40.0, crossing());
    if (!player) return 0.0;
    const BoundingBox& box = player->scenario().entities[2].box();
    EXPECT_LT(player->entities()[1].position.x, -kHalfM) << "there is room for the first one";
    EXPECT_LT(player->entities()[2].speedMps, 0.1);
    return player->entities()[2].position.x - box.centre.x - 0.5 * box.lengthM;
}

TEST(WayDriver, LetsNoMoreInThanHaveRoomBehindTheJunction)
{
    EXPECT_GT(frontOfSecondM(11.0), kHalfM);
    // The mutation: with room for both the second one stands behind the crossing, too.
    EXPECT_LT(frontOfSecondM(40.0), -kHalfM);
}

} // namespace
} // namespace simulation
