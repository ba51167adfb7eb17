// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/tessellate/QuadDiagonal.h>

namespace
{

using namespace osgPMObjects::core;

Quad withHeights(double a, double b, double c, double d)
{
    Quad quad;
    const double heights[4] = {a, b, c, d};
    for (int i = 0; i < 4; ++i)
        quad[i].position = {i == 1 || i == 2 ? 1.0 : 0.0, i >= 2 ? 1.0 : 0.0, heights[i]};
    return quad;
}

TEST(QuadDiagonal, OfAHeightFieldFollowsEachOfTheFourRules)
{
    // Heights 0 and 3 across from one another, 1 and 1 on the other diagonal: a valley side with a crease.
    const Quad quad = withHeights(0, 1, 3, 1);
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::nearestHeights), 1u);
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::largestHeightDifference), 0u);
    EXPECT_EQ(chooseDiagonal(withHeights(1, 0, 1, 3), DiagonalRule::nearestHeights), 0u);
    EXPECT_EQ(chooseDiagonal(withHeights(1, 0, 1, 3), DiagonalRule::largestHeightDifference), 1u);
    // By hand: 0–2 gives normals (2, -1, 1) and (-1, 2, 1), 120 degrees apart and of one length; 1–3 gives
    // (-1, -1, 1) and (2, 2, 1), 125 degrees apart and of lengths 1.7 and 3.
    const Quad tent = withHeights(2, 0, 1, 0);
    EXPECT_EQ(chooseDiagonal(tent, DiagonalRule::largestNormalAngle), 1u);
    EXPECT_EQ(chooseDiagonal(tent, DiagonalRule::nearestAreas), 0u);
    EXPECT_EQ(chooseDiagonal(withHeights(0, 2, 0, 1), DiagonalRule::largestNormalAngle), 0u);
    EXPECT_EQ(chooseDiagonal(withHeights(0, 2, 0, 1), DiagonalRule::nearestAreas), 1u);
}

TEST(QuadDiagonal, JoinsTheCornersThatDifferLeast)
{
    Quad quad = withHeights(0, 0, 0, 0);
    quad[0].colour = {1, 0, 0, 1};
    quad[2].colour = {0.9, 0, 0, 1};
    quad[1].colour = {0, 1, 0, 1};
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::leastColourDifference), 0u);
    quad[3].colour = quad[1].colour;
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::leastColourDifference), 1u);
    quad[0].normal = quad[1].normal = quad[2].normal = {0, 0, 1};
    quad[3].normal = {1, 0, 0};
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::leastNormalDifference), 0u);
    std::swap(quad[3].normal, quad[0].normal);
    EXPECT_EQ(chooseDiagonal(quad, DiagonalRule::leastNormalDifference), 1u);
}

TEST(QuadDiagonal, OfEqualOnesIsTheFirstForEveryRule)
{
    for (const auto rule : {DiagonalRule::leastColourDifference, DiagonalRule::leastNormalDifference,
                            DiagonalRule::largestNormalAngle, DiagonalRule::nearestAreas,
                            DiagonalRule::nearestHeights, DiagonalRule::largestHeightDifference})
        EXPECT_EQ(chooseDiagonal(withHeights(1, 1, 1, 1), rule), 0u);
}

TEST(QuadDiagonal, OfAConcaveQuadIsTheOneThatLiesInside)
{
    for (std::uint32_t reflex = 0; reflex < 4; ++reflex)
    {
        Quad quad = withHeights(0, 0, 0, 0);
        quad[reflex].position = 0.5 * (quad[(reflex + 1) % 4].position + quad[(reflex + 3) % 4].position) +
                                0.2 * (quad[(reflex + 2) % 4].position - quad[reflex].position);
        for (const auto rule : {DiagonalRule::nearestHeights, DiagonalRule::leastColourDifference})
            EXPECT_EQ(chooseDiagonal(quad, rule), reflex % 2) << reflex;
    }
}

TEST(QuadDiagonal, OfABowTieIsNone)
{
    Quad quad = withHeights(0, 0, 0, 0);
    std::swap(quad[1], quad[2]);
    EXPECT_FALSE(chooseDiagonal(quad, DiagonalRule::nearestHeights));
    EXPECT_FALSE(chooseDiagonal(quad, DiagonalRule::leastNormalDifference));
    for (QuadCorner& corner : quad)
        corner.position = {1, 2, 3};
    EXPECT_FALSE(chooseDiagonal(quad, DiagonalRule::nearestHeights));
}

} // namespace
