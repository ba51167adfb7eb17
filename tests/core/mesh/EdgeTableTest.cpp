// SPDX-License-Identifier: Apache-2.0
#include <random>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/EdgeTable.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;

TEST(EdgeTable, ACubeHasEighteenEdgesOfTwoSides)
{
    const auto triangles = positionTriangles(testsupport::cube());
    const EdgeTable edges(triangles, 8);
    ASSERT_EQ(edges.size(), 18u);
    for (std::uint32_t e = 0; e < edges.size(); ++e)
    {
        ASSERT_EQ(edges.sides(e).size(), 2u);
        const auto [from, to] = endsOf(triangles, edges.sides(e)[0]);
        EXPECT_EQ(endsOf(triangles, edges.sides(e)[1]), std::pair(to, from))
            << "neighbours run against each other";
    }
    EXPECT_TRUE(edges.describes(triangles));
}

TEST(EdgeTable, BoundariesAndCrowdedEdgesAreSeen)
{
    const std::vector<Triangle> fan = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    const EdgeTable edges(fan, 5);
    EXPECT_EQ(edges.size(), 7u);
    EXPECT_EQ(edges.sides(edges.edgeOf(0)).size(), 3u);
    EXPECT_FALSE(edges.isManifold(edges.edgeOf(0)));
    EXPECT_TRUE(edges.isBoundary(edges.edgeOf(1)));
}

TEST(EdgeTable, SidesWithoutLengthBelongToNoEdge)
{
    const std::vector<Triangle> thin = {{0, 0, 1}};
    const EdgeTable edges(thin, 2);
    EXPECT_EQ(edges.edgeOf(0), EdgeTable::kNone);
    EXPECT_EQ(edges.size(), 1u);
    EXPECT_TRUE(edges.describes(thin));
}

TEST(EdgeTable, DescribesWhateverItIsGiven)
{
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round)
    {
        const std::uint32_t positions = 3 + random() % 12;
        std::vector<Triangle> triangles(1 + random() % 40);
        for (Triangle& t : triangles)
            for (std::uint32_t& corner : t)
                corner = random() % positions;
        const EdgeTable edges(triangles, positions);
        ASSERT_TRUE(edges.describes(triangles)) << "round " << round;
        triangles.pop_back();
        ASSERT_FALSE(edges.describes(triangles));
    }
}

TEST(EdgeTable, DoesNotDescribeACubeWithAnyCornerElsewhere)
{
    const auto triangles = positionTriangles(testsupport::cube());
    const EdgeTable edges(triangles, 8);
    for (std::size_t face = 0; face < triangles.size(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            for (std::uint32_t other = 0; other < 8; ++other)
            {
                std::vector<Triangle> mutated = triangles;
                mutated[face][corner] = other;
                EXPECT_EQ(edges.describes(mutated), other == triangles[face][corner])
                    << face << ' ' << corner;
            }
}

} // namespace
