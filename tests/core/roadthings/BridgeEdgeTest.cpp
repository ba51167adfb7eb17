// SPDX-License-Identifier: Apache-2.0
// Where the edges and railings of a bridge stand, and where another road has its lanes.
#include <gtest/gtest.h>

#include "scenery/roads/things/RoadThings.h"

namespace
{

osgRoads::core::Road roadAlongX(const char* id, const glm::dvec2& from, double heightM)
{
    osgRoads::core::Road road;
    road.id = id;
    road.length = 100.0;
    road.isUsable = true;
    road.referenceLine = osgRoads::core::ReferenceLine(
        {osgRoads::core::PlanElement(0.0, 100.0, from, 0.0, osgRoads::core::LineShape{})});
    road.elevation = osgRoads::core::CubicProfile({{0.0, heightM, 0.0, 0.0, 0.0}});
    return road;
}

struct Edges
{
    int left = 0, right = 0; ///< posts of the railings
    double rightEndM = -1.0; ///< how far the bodies of the right edge reach along x
    double leftEndM = -1.0;  ///< and those of the left one
    std::size_t pieces = 0;  ///< what is swept along the bridge
};

/// A bridge from x = 20 to 80, whose edges stand 0.5 m beside its line; from x = 50 on another road runs
/// along its right edge.
Edges edgesOf(double otherHeightM, double otherY = -0.5)
{
    osgRoads::core::Road above = roadAlongX("1", {0.0, 0.0}, 8.0);
    osgRoads::core::RoadStructure bridge;
    bridge.s = 20.0;
    bridge.length = 60.0;
    above.structures = {bridge};
    auto network = std::make_shared<osgRoads::core::RoadNetwork>();
    network->roads.push_back(above);
    network->roads.push_back(roadAlongX("2", {50.0, otherY}, otherHeightM));
    network->index();
    const auto things = scenery::roads::placeRoadThings(osgRoads::core::PlacedNetwork(network));
    Edges edges;
    edges.pieces = things.own.size();
    for (const auto& post : things.standing)
        ++(post.position.y > 0.0 ? edges.left : edges.right);
    for (const auto& body : things.bodies.obstacles())
        if (body.kind == simulation::ObstacleKind::bridgeRail)
        {
            double& end = body.middle.y > 0.0 ? edges.leftEndM : edges.rightEndM;
            end = std::max(end, body.middle.x + std::max(body.halfM.x, body.halfM.y));
        }
    return edges;
}

} // namespace

TEST(BridgeEdge, EndsWhereAnotherRoadHasItsLanes)
{
    const Edges edges = edgesOf(8.0);
    EXPECT_EQ(edges.left, 30);
    EXPECT_EQ(edges.right, 15);
    EXPECT_NEAR(edges.leftEndM, 80.0, 1e-6);
    EXPECT_NEAR(edges.rightEndM, 49.5, 0.5);
}

TEST(BridgeEdge, StandsOverTheLanesOfARoadBelow)
{
    const Edges edges = edgesOf(2.0);
    EXPECT_EQ(edges.right, 30);
    EXPECT_NEAR(edges.rightEndM, 80.0, 1e-6);
    EXPECT_EQ(edges.pieces, 9U) << "two edges with three bars each, a deck";
}

TEST(BridgeEdge, StandsBesideTheLanesOfANeighbour)
{
    EXPECT_EQ(edgesOf(8.0, -1.0).right, 30);
}

TEST(BridgeEdge, GoesOnBehindARoadThatCrossesIt)
{
    // Both edges stop before the crossing road's line and go on behind it.
    osgRoads::core::Road above = roadAlongX("1", {0.0, 0.0}, 8.0),
                         across = roadAlongX("2", {50.0, -50.0}, 8.0);
    across.referenceLine = osgRoads::core::ReferenceLine({osgRoads::core::PlanElement(
        0.0, 100.0, {50.0, -50.0}, 1.5707963267948966, osgRoads::core::LineShape{})});
    osgRoads::core::RoadStructure bridge;
    bridge.s = 20.0;
    bridge.length = 60.0;
    above.structures = {bridge};
    auto network = std::make_shared<osgRoads::core::RoadNetwork>();
    network->roads = {above, across};
    network->index();
    const auto things = scenery::roads::placeRoadThings(osgRoads::core::PlacedNetwork(network));
    EXPECT_EQ(things.own.size(), 2U * 2U * 4U + 1U) << "two stretches of two edges with their bars, a deck";
}
