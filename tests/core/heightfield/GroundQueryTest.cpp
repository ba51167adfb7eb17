// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

/// Heights on which every two triangulations differ.
HeightField roughField(int columns, int rows)
{
    HeightField field;
    field.columns = columns;
    field.rows = rows;
    field.spacingEastM = 30.0;
    field.spacingNorthM = 20.0;
    std::mt19937 random(3);
    for (int i = 0; i < columns * rows; ++i)
        field.heightsM.push_back(static_cast<float>(random() % 500));
    return field;
}

HeightField curvedField(int columns, int rows)
{
    return testsupport::onTheEarth(roughField(columns, rows));
}

using Triangle = std::array<glm::ivec2, 3>; ///< apex, left, right

/// Calls `visit` with every triangle of the finest level, by splitting from the roots: apex to middle of the
/// base.
void splitToFinest(const Triangle& t, const std::function<void(const Triangle&)>& visit)
{
    const glm::ivec2 base = t[2] - t[1];
    if (base.x % 2 != 0 || base.y % 2 != 0)
    {
        visit(t);
        return;
    }
    const glm::ivec2 middle = t[1] + base / 2;
    splitToFinest({middle, t[0], t[1]}, visit);
    splitToFinest({middle, t[2], t[0]}, visit);
}

void visitFinest(int side, const std::function<void(const Triangle&)>& visit)
{
    const int n = side - 1;
    splitToFinest({glm::ivec2(n, 0), glm::ivec2(n, n), glm::ivec2(0, 0)}, visit);
    splitToFinest({glm::ivec2(0, n), glm::ivec2(0, 0), glm::ivec2(n, n)}, visit);
}

/// Largest vertical difference between groundAt and the triangles of the bintree, at points within each.
double worstAgainstBintree(const PlacedTile& tile)
{
    double worst = 0.0;
    int triangles = 0;
    visitFinest(tile.grid().side(),
                [&](const Triangle& t)
                {
                    for (const glm::ivec2& corner : t)
                        if (corner.x >= tile.grid().dataColumns() || corner.y >= tile.grid().dataRows())
                            return;
                    ++triangles;
                    glm::dvec3 p[3];
                    for (int k = 0; k < 3; ++k)
                        p[k] = tile.position(t[k].x, t[k].y);
                    for (const glm::dvec3 b : {glm::dvec3(0.2, 0.5, 0.3), glm::dvec3(0.4, 0.55, 0.05),
                                               glm::dvec3(0.02, 0.38, 0.6), glm::dvec3(0.96, 0.02, 0.02)})
                    {
                        const glm::dvec3 expected = b.x * p[0] + b.y * p[1] + b.z * p[2];
                        const auto ground = groundAt(tile, expected.x, expected.y);
                        worst = std::max(worst, ground ? std::abs(ground->position.z - expected.z) : 1e9);
                    }
                });
    EXPECT_EQ(triangles, 2 * (tile.grid().dataColumns() - 1) * (tile.grid().dataRows() - 1));
    return worst;
}

TEST(GroundQuery, PlanarGroundIsTheFinestTriangleOfTheBintree)
{
    EXPECT_LT(worstAgainstBintree(PlacedTile(roughField(17, 17))), 1e-9);
    EXPECT_LT(worstAgainstBintree(PlacedTile(roughField(14, 9))), 1e-9);
    EXPECT_LT(worstAgainstBintree(PlacedTile(roughField(3, 3))), 1e-9);
}

TEST(GroundQuery, CurvedGroundIsTheFinestTriangleOfTheBintree)
{
    EXPECT_LT(worstAgainstBintree(PlacedTile(curvedField(33, 33))), 1e-6);
    EXPECT_LT(worstAgainstBintree(PlacedTile(curvedField(33, 20), Geodetic{46.0, 8.0, 0.0})), 1e-6);
}

TEST(GroundQuery, FarFromTheOriginTheTiltedEarthIsStillMet)
{
    // Three degrees away the vertical of the frame leans by three degrees, and a height moves its sample
    // sideways.
    EXPECT_LT(worstAgainstBintree(PlacedTile(curvedField(33, 33), Geodetic{49.0, 8.0, 0.0})), 1e-6);
}

TEST(GroundQuery, TheOtherDiagonalsAreNoticed)
{
    // A field moved by one column has all its diagonals turned; its ground must differ from the bintree's.
    const HeightField field = roughField(17, 17);
    const PlacedTile tile(field);
    HeightField shifted = field;
    for (int r = 0; r < 17; ++r)
        for (int c = 0; c < 17; ++c)
            shifted.heightsM[static_cast<std::size_t>(r) * 17 + c] = field.heightM(c + 1, r);
    const PlacedTile other(shifted);
    double worst = 0.0;
    for (int c = 0; c < 15; ++c)
    {
        const double east = (c + 0.5) * 30.0, north = 5.4 * 20.0;
        worst = std::max(worst, std::abs(groundAt(other, east, north)->position.z -
                                         groundAt(tile, east + 30.0, north)->position.z));
    }
    EXPECT_GT(worst, 10.0);
}

TEST(GroundQuery, SamplesAreOnTheGround)
{
    const PlacedTile tile(curvedField(33, 20));
    for (int r = 1; r < 19; ++r)
        for (int c = 1; c < 32; ++c)
        {
            const glm::dvec3 p = tile.position(c, r);
            const auto ground = groundAt(tile, p.x, p.y);
            ASSERT_TRUE(ground);
            EXPECT_NEAR(ground->position.z, p.z, 1e-5);
        }
}

TEST(GroundQuery, ThereIsNoGroundBeyondTheData)
{
    const PlacedTile tile(roughField(14, 9));
    EXPECT_TRUE(groundAt(tile, 0.0, 0.0));
    EXPECT_TRUE(groundAt(tile, 13 * 30.0, 8 * 20.0));
    EXPECT_FALSE(groundAt(tile, 13 * 30.0 + 0.01, 50.0));
    EXPECT_FALSE(groundAt(tile, 50.0, 8 * 20.0 + 0.01));
    EXPECT_FALSE(groundAt(tile, -0.01, 50.0));
    EXPECT_FALSE(groundAt(tile, 1e12, 50.0));
    EXPECT_FALSE(groundAt(tile, std::numeric_limits<double>::quiet_NaN(), 50.0));
    const PlacedTile curved(curvedField(14, 9));
    EXPECT_FALSE(groundAt(curved, 1e5, 0.0));
    EXPECT_FALSE(groundAt(curved, 1e9, 1e9));
}

TEST(GroundQuery, NormalIsThatOfTheTriangleAndPointsUp)
{
    HeightField field = roughField(9, 9);
    for (int r = 0; r < 9; ++r)
        for (int c = 0; c < 9; ++c)
            field.heightsM[static_cast<std::size_t>(r) * 9 + c] = static_cast<float>(3 * c - 2 * r);
    const auto ground = groundAt(PlacedTile(field), 101.0, 77.0);
    ASSERT_TRUE(ground);
    const glm::dvec3 expected = glm::normalize(glm::dvec3(-3.0 / 30.0, 2.0 / 20.0, 1.0));
    EXPECT_LT(glm::distance(ground->normal, expected), 1e-12);
    EXPECT_NEAR(ground->position.z, 3.0 * 101.0 / 30.0 - 2.0 * 77.0 / 20.0, 1e-9);
}

} // namespace
