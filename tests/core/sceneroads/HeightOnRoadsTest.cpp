// SPDX-License-Identifier: Apache-2.0
#include "scenery/roads/HeightOnRoads.h"

#include <cmath>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <osgRoads/core/read/ReadNetwork.h>

#include "TunnelScene.h"

namespace
{

using osgRoads::core::PlacedNetwork;

std::string lane(const std::string& id, const std::string& type, double widthM, const std::string& more = "")
{
    return "<lane id=\"" + id + "\" type=\"" + type + "\" level=\"false\"><width sOffset=\"0\" a=\"" +
           std::to_string(widthM) + "\" b=\"0\" c=\"0\" d=\"0\"/>" + more + "</lane>";
}

/// A road of 200 m through (0, 0), one lane of 4 m on each side and a sidewalk of 2 m, 0.12 m higher, on the
/// right.
std::string road(const std::string& id, double headingRad, double heightM, const std::string& junction)
{
    const auto number = [](double value) { return std::to_string(value); };
    return "<road id=\"" + id + "\" length=\"200\" junction=\"" + junction +
           "\"><planView><geometry s=\"0\" x=\"" + number(-100.0 * std::cos(headingRad)) + "\" y=\"" +
           number(-100.0 * std::sin(headingRad)) + "\" hdg=\"" + number(headingRad) +
           "\" length=\"200\"><line/></geometry></planView><elevationProfile><elevation s=\"0\" a=\"" +
           number(heightM) +
           "\" b=\"0\" c=\"0\" d=\"0\"/></elevationProfile><lanes><laneSection s=\"0\"><left>" +
           lane("1", "driving", 4.0) +
           "</left><center><lane id=\"0\" type=\"none\" level=\"false\"/></center><right>" +
           lane("-1", "driving", 4.0) +
           lane("-2", "sidewalk", 2.0, R"(<height sOffset="0" inner="0.12" outer="0.12"/>)") +
           "</right></laneSection></lanes></road>";
}

/// Road 1 along x at 0 m, road 2 across it along y.
PlacedNetwork crossing(double secondHeightM)
{
    auto read = osgRoads::core::parseNetwork(
        "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>" + road("1", 0.0, 0.0, "-1") +
            road("2", std::acos(0.0), secondHeightM, "-1") + "</OpenDRIVE>",
        "crossing.xodr");
    EXPECT_TRUE(read);
    return PlacedNetwork(std::make_shared<const osgRoads::core::RoadNetwork>(std::move(read->network)));
}

} // namespace

using scenery::heightOnRoads;

TEST(HeightOnRoads, UnderABridgeItIsTheRoadBelowAndOnItTheBridge)
{
    const PlacedNetwork roads = crossing(6.0);
    const glm::dvec3 bed(0.0, 1.0, -0.5);
    EXPECT_NEAR(heightOnRoads(roads, bed, 0.2), 0.0, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, bed, 2.8), 0.0, 1e-9) << "a camera behind a car";
    EXPECT_NEAR(heightOnRoads(roads, bed, 5.3), 6.0, 1e-9) << "wheels that are a little below the deck";
    EXPECT_NEAR(heightOnRoads(roads, bed, 6.2), 6.0, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, bed, -7.0), 0.0, 1e-9) << "from below all";
    EXPECT_NEAR(heightOnRoads(roads, bed, INFINITY), 6.0, 1e-9) << "of unknown height";
}

TEST(HeightOnRoads, UnderABridgeAndBesideARoadItIsTheGround)
{
    const PlacedNetwork roads = crossing(6.0);
    EXPECT_NEAR(heightOnRoads(roads, {1.0, 50.0, -0.4}, 0.0), -0.4, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, {1.0, 50.0, -0.4}, 6.0), 6.0, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, {1.0, 120.0, -0.4}, 6.0), -0.4, 1e-9) << "beyond the bridge's end";
}

TEST(HeightOnRoads, BesideTheLanesOfABridgeItIsTheDeckAsFarAsThatReaches)
{
    std::string text = "<OpenDRIVE><header revMajor=\"1\" revMinor=\"7\"/>" + road("1", 0.0, 8.0, "-1");
    const std::size_t end = text.rfind("</road>");
    const auto placedWith = [&](const std::string& objects)
    {
        auto read = osgRoads::core::parseNetwork(
            text.substr(0, end) + objects + text.substr(end) + "</OpenDRIVE>", "bridge.xodr");
        EXPECT_TRUE(read);
        return PlacedNetwork(std::make_shared<const osgRoads::core::RoadNetwork>(std::move(read->network)));
    };
    const PlacedNetwork bridge =
        placedWith("<objects><bridge id=\"b\" s=\"50\" length=\"100\" type=\"concrete\"/></objects>");
    for (const double besideM : {0.05, 0.2, 0.3, 0.4, 0.45})
        EXPECT_NEAR(heightOnRoads(bridge, {0.0, 4.0 + besideM, 0.0}, 8.0), 8.0, 0.05) << besideM;
    EXPECT_NEAR(heightOnRoads(bridge, {0.0, 4.6, 0.0}, 8.0), 0.0, 1e-9) << "beyond the deck";
    const PlacedNetwork tunnel =
        placedWith("<objects><tunnel id=\"t\" s=\"50\" length=\"100\" type=\"standard\"/></objects>");
    EXPECT_GT(heightOnRoads(tunnel, {0.0, 4.3, 0.0}, 8.0), 8.01) << "a walkway, no deck";
}

TEST(HeightOnRoads, InATunnelItIsTheRoadAndAboveItTheHill)
{
    const PlacedNetwork roads = crossing(6.0);
    const glm::dvec3 hill(50.0, 1.0, 20.0);
    EXPECT_NEAR(heightOnRoads(roads, hill, 0.1), 0.0, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, hill, 19.5), 20.0, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, hill, INFINITY), 0.0, 1e-9);
}

TEST(HeightOnRoads, ASidewalkGivesWayToTheCarriagewayThatCrossesIt)
{
    const PlacedNetwork roads = crossing(0.05);
    // Road 2 runs north: its lanes lie between x = -4 and 4, its sidewalk between 4 and 6.
    EXPECT_NEAR(heightOnRoads(roads, {0.0, -5.0, -0.5}, 0.0), 0.05, 1e-9)
        << "sidewalk of 1, carriageway of 2";
    EXPECT_NEAR(heightOnRoads(roads, {5.0, 1.0, -0.5}, 0.0), 0.0, 1e-9) << "carriageway of 1, sidewalk of 2";
    EXPECT_NEAR(heightOnRoads(roads, {0.0, 1.0, -0.5}, 0.0), 0.05, 1e-9) << "of two carriageways the higher";
    EXPECT_NEAR(heightOnRoads(roads, {50.0, -5.0, -0.5}, 0.0), 0.12, 1e-9) << "sidewalk alone";
}

TEST(HeightOnRoads, TheVergeFallsOutwardsUntilTheGroundIsHigher)
{
    const PlacedNetwork roads = crossing(6.0);
    EXPECT_NEAR(heightOnRoads(roads, {50.0, 5.0, -0.5}, 0.0), -0.06, 1e-9) << "1 m beside the left lane";
    EXPECT_NEAR(heightOnRoads(roads, {50.0, 5.0, -0.04}, 0.0), -0.04, 1e-9);
    EXPECT_NEAR(heightOnRoads(roads, {50.0, 6.6, -0.5}, 0.0), -0.5, 1e-9) << "beyond the verge";
}

TEST(HeightOnRoads, InATunnelItIsTheRoadOrTheWalkwayWhateverGroundIsInTheTube)
{
    const auto roads = tunnelscene::road();
    const auto heightAt = [&](double x, double besideM, double groundM) {
        return heightOnRoads(*roads, {x, tunnelscene::kRoadY + besideM, groundM}, tunnelscene::kRoadM + 0.1);
    };
    const double inside = tunnelscene::kPortalX + 5.0, outside = tunnelscene::kPortalX - 5.0;
    EXPECT_NEAR(heightAt(inside, 1.0, 6.2), 5.0, 1e-9) << "the slope behind the portal crosses the tube";
    EXPECT_NEAR(heightAt(outside, 1.0, 6.2), 6.2, 1e-9) << "a heap on the road counts";
    EXPECT_NEAR(heightAt(inside, 4.0, 5.2), 5.15, 1e-9) << "the walkway";
    EXPECT_NEAR(heightAt(inside, 6.0, 5.2), 5.2, 1e-9) << "beside the tube";
}
