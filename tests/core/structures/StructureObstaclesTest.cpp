// SPDX-License-Identifier: Apache-2.0
// What vehicles meet of structures, by hand.
#include "scenery/structures/StructureObstacles.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace
{

using scenery::StructureKind;
using simulation::ObstacleKind;

std::vector<simulation::Obstacle> obstaclesOf(StructureKind kind, std::vector<glm::dvec2> line)
{
    scenery::Structure structure;
    structure.kind = kind;
    structure.line = std::move(line);
    structure.heightM = kind == StructureKind::powerLine ? 28.0 : 1.5;
    simulation::ObstacleList list;
    scenery::addObstacles(
        {structure}, [](const glm::dvec2& at) { return 0.1 * at.x; }, list);
    return list.obstacles();
}

TEST(StructureObstacles, AWallFollowsTheGroundInPieces)
{
    const auto pieces = obstaclesOf(StructureKind::wall, {{0.0, 0.0}, {40.0, 0.0}});
    ASSERT_EQ(pieces.size(), 10U);
    EXPECT_EQ(pieces.front().kind, ObstacleKind::wall);
    EXPECT_EQ(pieces[5].middle, glm::dvec2(22.0, 0.0));
    EXPECT_NEAR(pieces[5].highM, 2.4 + 1.5, 1e-9); // of its higher end
    EXPECT_LT(pieces[5].lowM, 2.0);
    EXPECT_NEAR(pieces[5].halfM.y, 0.2, 1e-9);
}

TEST(StructureObstacles, APylonStandsOnFourLegsAndARailwayIsNotInTheWay)
{
    const auto legs = obstaclesOf(StructureKind::powerLine, {{0.0, 0.0}, {300.0, 0.0}});
    ASSERT_EQ(legs.size(), 8U);
    EXPECT_TRUE(std::all_of(legs.begin(), legs.end(), [](const auto& leg) { return leg.isRound; }));
    EXPECT_TRUE(obstaclesOf(StructureKind::railway, {{0.0, 0.0}, {300.0, 0.0}}).empty());
}

} // namespace
