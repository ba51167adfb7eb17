// SPDX-License-Identifier: Apache-2.0
// What is painted besides the marks along borders, worked by hand.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgRoads/core/query/PaintedItem.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/Decal.h>

#include "RoadTexts.h"

namespace
{

using namespace osgRoads::core;
using namespace roadtexts;

PlacedNetwork straightWith(const std::string& content)
{
    return PlacedNetwork(std::make_shared<const RoadNetwork>(
        sound(network(road("1", 100.0, straightPlan(100.0) + twoLanes() + content)))));
}

std::string object(const std::string& attributes)
{
    return "<objects><object id=\"1\" zOffset=\"0\" " + attributes + "/></objects>";
}

std::string signal(const std::string& attributes)
{
    return "<signals><signal id=\"1\" country=\"de\" subtype=\"-1\" dynamic=\"no\" zOffset=\"0\" " +
           attributes + "/></signals>";
}

/// A road of 100 m along x whose middle has explicit lines.
std::string explicitRoad(const std::string& plan)
{
    return network(road(
        "1", 100.0,
        plan +
            R"(<lanes><laneSection s="0"><center><lane id="0" type="none"><roadMark sOffset="10" type="custom" width="0.15" color="yellow">
<explicit><line length="3" tOffset="0.25" sOffset="4" width="0.2"/><line length="60" tOffset="0" sOffset="20"/></explicit></roadMark></lane></center>
<right><lane id="-1" type="driving">)" +
            kWidth + "</lane></right></laneSection></lanes>"));
}

double areaOf(const std::vector<Decal>& decals)
{
    double area = 0.0;
    for (const Decal& decal : decals)
        area += 0.5 * (decal.widthStart + decal.widthEnd) * decal.length;
    return area;
}

void expectNear(const glm::dvec2& value, const glm::dvec2& wanted)
{
    EXPECT_LT(glm::distance(value, wanted), 1e-6) << value.x << ' ' << value.y;
}

TEST(RoadDecals, ExplicitLinesLieWhereTheFileHasThem)
{
    const auto decals = roadDecals(
        PlacedNetwork(std::make_shared<const RoadNetwork>(sound(explicitRoad(straightPlan(100.0))))));
    ASSERT_EQ(decals.size(), 5u); // 3 m; 60 m in four pieces
    expectNear(glm::dvec2(decals[0].start), {14.0, 0.25});
    EXPECT_NEAR(decals[0].length, 3.0, 1e-6);
    EXPECT_EQ(decals[0].widthStart, 0.2);
    EXPECT_EQ(decals[1].widthStart, 0.15);
    expectNear(glm::dvec2(decals[1].start), {30.0, 0.0});
    EXPECT_GT(decals[0].paint.r, 3.0 * decals[0].paint.b); // yellow
}

TEST(RoadDecals, ExplicitLinesOfABendAreCutIntoStraightPieces)
{
    const std::string plan = "<planView>" +
                             geometry(R"(s="0" x="0" y="0" hdg="0")", 100.0, R"(<arc curvature="0.02"/>)") +
                             "</planView>";
    const PlacedNetwork bent(std::make_shared<const RoadNetwork>(sound(explicitRoad(plan))));
    double length = 0.0;
    for (const Decal& decal : roadDecals(bent))
    {
        length += decal.length;
        // The middle of a piece lies within 5 mm of the arc of 50 m (the first line: 49.75 m) about (0, 50).
        const glm::dvec2 middle = glm::dvec2(decal.start) + decal.along * (0.5 * decal.length);
        const double radius = decal.widthStart == 0.2 ? 49.75 : 50.0;
        EXPECT_NEAR(glm::distance(middle, glm::dvec2(0.0, 50.0)), radius, 0.0051);
    }
    EXPECT_NEAR(length, 60.0 + 3.0 * 49.75 / 50.0, 0.01);
}

/// A sway may leap as far as numbers go: a line of it is some thousand pieces, not one each 16 m.
TEST(RoadDecals, ALineThatLeapsAwayHasAnEnd)
{
    std::string text = explicitRoad(straightPlan(100.0));
    const std::string end = "</explicit>";
    text.insert(text.find(end) + end.size(), R"(<sway ds="0" a="0" b="0" c="0" d="1e12"/>)");
    const auto decals = roadDecals(placed(text));
    EXPECT_GE(decals.size(), 2u);
    EXPECT_LE(decals.size(), 2048u);
}

TEST(RoadDecals, AStopLineStaysOnTheSideThatItStops)
{
    // The middle of the road is told as its place: traffic to lesser s keeps to greater t.
    const auto decals = roadDecals(
        straightWith(signal(R"(type="294" s="40" t="0" orientation="-" width="3.5" height="0.01")")));
    ASSERT_EQ(decals.size(), 1u);
    expectNear(glm::dvec2(decals[0].start), {40.0, 0.0});
    EXPECT_NEAR(decals[0].length, 3.5, 1e-9);
    expectNear(decals[0].along, {0.0, 1.0});
    EXPECT_EQ(decals[0].widthStart, 0.5);
    // Told at the middle of its lane it lies there.
    const auto other = roadDecals(
        straightWith(signal(R"(type="294" s="40" t="-1.75" orientation="+" width="3.5" height="0.01")")));
    ASSERT_EQ(other.size(), 1u);
    expectNear(glm::dvec2(other[0].start), {40.0, -3.5});
}

TEST(RoadDecals, ACrosswalkHasStripesAlongTheRoad)
{
    const auto decals =
        roadDecals(straightWith(object(R"(type="crosswalk" s="50" t="0" hdg="0" length="4" width="7")")));
    ASSERT_EQ(decals.size(), 1u);
    EXPECT_NEAR(std::fabs(decals[0].along.y), 1.0, 1e-9); // stripes follow each other across the road
    EXPECT_NEAR(decals[0].length, 7.0, 1e-9);
    EXPECT_NEAR(decals[0].widthStart, 4.0, 1e-9);
    EXPECT_EQ(decals[0].dash, 0.5);
    EXPECT_EQ(decals[0].period, 1.0);
}

TEST(RoadDecals, AnOutlineIsPaintedWithItsArea)
{
    // An L of 4 m by 3 m without a corner of 2 m by 2 m.
    std::string corners;
    for (const char* uv : {R"(u="0" v="0")", R"(u="4" v="0")", R"(u="4" v="1")", R"(u="2" v="1")",
                           R"(u="2" v="3")", R"(u="0" v="3")"})
        corners += std::string("<cornerLocal ") + uv + " z=\"0\" height=\"0\"/>";
    const auto decals = roadDecals(straightWith(
        R"(<objects><object id="1" zOffset="0" type="roadMark" s="50" t="-1" hdg="0.4"><outlines><outline id="0">)" +
        corners + "</outline></outlines></object></objects>"));
    EXPECT_NEAR(areaOf(decals), 8.0, 1e-9);
}

TEST(RoadDecals, ArrowsPointWhereTheirNamesSay)
{
    RoadItem item;
    item.subtype = "arrowStraightLeft";
    EXPECT_EQ(arrowHeads(item), (ArrowHeads{true, true, false, 0}));
    item.subtype = "-1";
    item.name = "SgRMArrowRight.flt";
    EXPECT_EQ(arrowHeads(item), (ArrowHeads{false, false, true, 0}));
    // Towards lesser s: the tip lies before the foot.
    const auto decals = roadDecals(
        straightWith(signal(R"(type="297" s="50" t="1.75" orientation="-" width="1" height="0.01")")));
    ASSERT_EQ(decals.size(), 2u);
    expectNear(glm::dvec2(decals[0].start), {52.5, 1.75});
    EXPECT_EQ(decals[1].widthEnd, 0.0);
    EXPECT_NEAR(decals[1].start.x - decals[1].length, 47.5, 1e-9);
}

TEST(RoadDecals, AParkingSpaceIsOpenTowardsTheRoad)
{
    const auto decals =
        roadDecals(straightWith(object(R"(type="parkingSpace" s="50" t="-3" hdg="0" length="5" width="2")")));
    ASSERT_EQ(decals.size(), 3u);
    for (const Decal& decal : decals)
        EXPECT_LT((decal.corners()[0].y + decal.corners()[2].y) / 2.0,
                  -2.1); // the side at t = -2 is not painted
}

/// A parking space of 5 m by 2 m about (50, -3) with what stands in it.
std::string space(const std::string& content)
{
    return R"(<objects><object id="1" zOffset="0" type="parkingSpace" s="50" t="-3" hdg="0" length="5" width="2">)" +
           content + "</object></objects>";
}

std::string marking(const std::string& attributes, const std::string& corners = "")
{
    return "<marking color=\"yellow\" width=\"0.2\" " + attributes + ">" + corners + "</marking>";
}

TEST(RoadDecals, MarkingsTakeThePlaceOfTheDefaultLinesOfASpace)
{
    const auto decals = roadDecals(straightWith(
        space("<markings>" +
              marking(R"(side="left" lineLength="0" spaceLength="0" startOffset="0.5" stopOffset="1")") +
              marking(R"(side="rear" lineLength="0.5" spaceLength="0.25" startOffset="0" stopOffset="0")") +
              "</markings>")));
    ASSERT_EQ(decals.size(), 2u);
    expectNear(glm::dvec2(decals[0].start), {48.0, -2.0}); // the left side is at t -2, from s 47.5 to 52.5
    expectNear(decals[0].along, {1.0, 0.0});
    EXPECT_NEAR(decals[0].length, 3.5, 1e-9);
    EXPECT_EQ(decals[0].widthStart, 0.2);
    EXPECT_EQ(decals[0].period, 0.0);
    EXPECT_GT(decals[0].paint.r, 3.0 * decals[0].paint.b); // yellow
    expectNear(glm::dvec2(decals[1].start), {47.5, -4.0});
    expectNear(decals[1].along, {0.0, 1.0});
    EXPECT_EQ(decals[1].dash, 0.5);
    EXPECT_EQ(decals[1].period, 0.75);
}

TEST(RoadDecals, DashesOfAMarkingGoOnAroundACorner)
{
    const std::string outline =
        R"(<outlines><outline id="0"><cornerLocal id="0" u="0" v="0" z="0"/><cornerLocal id="1" u="4" v="0" z="0"/>
<cornerLocal id="2" u="4" v="3" z="0"/></outline></outlines>)";
    const auto decals = roadDecals(straightWith(
        space(outline + "<markings>" +
              marking(R"(lineLength="1" spaceLength="0.5" startOffset="1" stopOffset="1")",
                      R"(<cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/>)") +
              "</markings>")));
    ASSERT_EQ(decals.size(), 2u);
    expectNear(glm::dvec2(decals[0].start), {51.0, -3.0});
    EXPECT_NEAR(decals[0].length, 3.0, 1e-9); // two whole periods of 1.5 m
    expectNear(glm::dvec2(decals[1].start), {54.0, -3.0});
    EXPECT_NEAR(decals[1].length, 2.0, 1e-9);
    EXPECT_NEAR(decals[1].phase, 0.0, 1e-9);
    // A metre less before the corner: the pattern is 0.5 m on at it.
    const auto later = roadDecals(straightWith(
        space(outline + "<markings>" +
              marking(R"(lineLength="1" spaceLength="0.5" startOffset="2" stopOffset="0")",
                      R"(<cornerReference id="0"/><cornerReference id="1"/><cornerReference id="2"/>)") +
              "</markings>")));
    ASSERT_EQ(later.size(), 2u);
    EXPECT_NEAR(later[1].phase, 0.5, 1e-9);
}

TEST(RoadDecals, AnObjectWithoutPaintOfItsOwnMayHaveMarkings)
{
    const auto island = [](const std::string& content)
    {
        return roadDecals(straightWith(
            R"(<objects><object id="1" zOffset="0" type="trafficIsland" s="50" t="0" hdg="0.5" length="5" width="2">)" +
            content + "</object></objects>"));
    };
    EXPECT_EQ(island("").size(), 0u);
    const auto decals =
        island("<markings>" +
               marking(R"(side="front" lineLength="0" spaceLength="0" startOffset="0" stopOffset="0")") +
               "</markings>");
    ASSERT_EQ(decals.size(), 1u); // from the right to the left corner of the front, turned by 0.5 rad
    expectNear(glm::dvec2(decals[0].start),
               {50.0 + 2.5 * std::cos(0.5) + std::sin(0.5), 2.5 * std::sin(0.5) - std::cos(0.5)});
    expectNear(decals[0].along, {-std::sin(0.5), std::cos(0.5)});
}

/// Counts the strips of a mesh on which something is painted, and the rows of all lists.
std::pair<std::size_t, std::size_t> painted(const RoadMesh& mesh)
{
    std::vector<std::uint32_t> rows;
    for (const MeshVertex& vertex : mesh.vertices)
        if (vertex.decalRow > 0) rows.push_back(vertex.decalRow);
    std::sort(rows.begin(), rows.end());
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    return {rows.size(), mesh.decals.size()};
}

TEST(RoadDecals, AreListedOnTheStripsThatTheyLieOn)
{
    // On the right lane of one chunk only.
    const auto arrow = painted(buildRoadMesh(
        straightWith(signal(R"(type="297" s="20" t="-1.75" orientation="+" width="1" height="0.01")"))));
    EXPECT_EQ(arrow.first, 1u);
    EXPECT_EQ(arrow.second, 1u + 1u + 2u);
    // Over both lanes.
    const auto crosswalk = painted(
        buildRoadMesh(straightWith(object(R"(type="crosswalk" s="20" t="0" hdg="0" length="4" width="7")"))));
    EXPECT_EQ(crosswalk.first, 2u);
    EXPECT_EQ(painted(buildRoadMesh(straightWith(""))).first, 0u);
}

TEST(RoadDecals, ReachIntoTheNextRoad)
{
    const std::string next = road("2", 50.0,
                                  "<planView>" + geometry(R"(s="0" x="100" y="0" hdg="0")", 50.0, "<line/>") +
                                      "</planView>" + twoLanes());
    const auto read = std::make_shared<const RoadNetwork>(
        sound(network(road("1", 100.0,
                           straightPlan(100.0) + twoLanes() +
                               object(R"(type="crosswalk" s="100" t="0" hdg="0" length="4" width="7")")) +
                      next)));
    EXPECT_EQ(painted(buildRoadMesh(PlacedNetwork(read))).first, 4u);
}

TEST(RoadDecals, AreNotPaintedOnTheRoadBelow)
{
    const std::string below = road(
        "2", 50.0,
        "<planView>" + geometry(R"(s="0" x="20" y="-25" hdg="1.5707963")", 50.0, "<line/>") +
            R"(</planView><elevationProfile><elevation s="0" a="-6" b="0" c="0" d="0"/></elevationProfile>)" +
            twoLanes());
    const auto read = std::make_shared<const RoadNetwork>(
        sound(network(road("1", 100.0,
                           straightPlan(100.0) + twoLanes() +
                               object(R"(type="crosswalk" s="20" t="0" hdg="0" length="4" width="7")")) +
                      below)));
    EXPECT_EQ(painted(buildRoadMesh(PlacedNetwork(read))).first, 2u);
}

} // namespace
