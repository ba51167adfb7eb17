// SPDX-License-Identifier: Apache-2.0
#include <random>

#include <GeographicLib/LocalCartesian.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/PlacedTile.h>

namespace
{

using namespace osgTerrainROAM::core;

constexpr double kStepDeg = 3.0 / 3600.0;

float rolling(int column, int row)
{
    return static_cast<float>((column * 37 + row * 91) % 3000 - 200);
}

/// A geographic field of 3" with a net of the given step; the geoid rises eastwards.
HeightField geographicField(int columns, int rows, int step, double southDeg, double westDeg)
{
    HeightField field;
    field.columns = columns;
    field.rows = rows;
    field.spacingEastM = field.spacingNorthM = 90.0;
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c)
            field.heightsM.push_back(rolling(c, r));
    GeodeticNet net;
    net.step = step;
    net.nodesPerSide = (field.tileSide() - 1) / step + 1;
    for (int b = 0; b < net.nodesPerSide; ++b)
        for (int a = 0; a < net.nodesPerSide; ++a)
            net.nodes.push_back(
                {southDeg + b * step * kStepDeg, westDeg + a * step * kStepDeg, 40.0 + 0.01 * a * step});
    field.net = net;
    return field;
}

glm::dvec3 direct(const PlacedTile& tile, double southDeg, double westDeg, int column, int row)
{
    const Geodetic& o = tile.frame().origin();
    const GeographicLib::LocalCartesian frame(o.latitudeDeg, o.longitudeDeg, o.heightM);
    glm::dvec3 p;
    frame.Forward(southDeg + row * kStepDeg, westDeg + column * kStepDeg,
                  tile.samples().heightM(column, row) + 40.0 + 0.01 * column, p.x, p.y, p.z);
    return p;
}

TEST(PlacedTile, PlanarPositionsAreExactProducts)
{
    HeightField field = geographicField(6, 4, 4, 46.0, 8.0);
    field.net.reset();
    field.spacingEastM = 4.988744589;
    field.spacingNorthM = 1.0 / 3.0;
    const PlacedTile tile(field, Placement::planar);
    EXPECT_EQ(tile.grid().side(), 9);
    EXPECT_EQ(tile.grid().levels(), 6);
    for (int r = 0; r < tile.grid().side(); ++r)
        for (int c = 0; c < tile.grid().side(); ++c)
        {
            const glm::dvec3 p = tile.position(c, r);
            EXPECT_EQ(p.x, c * 4.988744589);
            EXPECT_EQ(p.y, r * (1.0 / 3.0));
            EXPECT_EQ(p.z, static_cast<double>(rolling(std::min(c, 5), std::min(r, 3))));
        }
    EXPECT_EQ(tile.frame().gridAt(tile.frame().positionAt(2.5, 1.25, 9.0)), glm::dvec2(2.5, 1.25));
}

TEST(PlacedTile, WithoutGeoreferenceTheTileIsPlanarWhateverIsAsked)
{
    HeightField field = geographicField(6, 4, 4, 46.0, 8.0);
    field.net.reset();
    EXPECT_EQ(PlacedTile(field, Placement::curved).frame().placement(), Placement::planar);
    EXPECT_EQ(PlacedTile(field, Geodetic{46.0, 8.0, 0.0}).frame().placement(), Placement::planar);
}

TEST(PlacedTile, CurvedPositionsAreWithinAMillimetreOfTheEllipsoid)
{
    for (const double south : {-33.0, 0.0, 46.0, 69.0})
    {
        const PlacedTile tile(geographicField(700, 1025, 64, south, 8.0));
        double worst = 0.0;
        for (int r = 0; r < 1025; r += 3)
            for (int c = 0; c < 700; c += 3)
                worst = std::max(worst, glm::distance(tile.position(c, r), direct(tile, south, 8.0, c, r)));
        EXPECT_LT(worst, 0.001) << south;
    }
}

TEST(PlacedTile, ANetTooCoarseOrMovedByAMicrodegreeBreaksTheMillimetre)
{
    HeightField field = geographicField(700, 1025, 64, 46.0, 8.0);
    for (GeodeticNet::Node& node : field.net->nodes)
        node.latitudeDeg += 1e-6;
    const PlacedTile moved(field, Geodetic{46.4, 8.3, 0.0});
    EXPECT_GT(glm::distance(moved.position(100, 100), direct(moved, 46.0, 8.0, 100, 100)), 0.05);

    const PlacedTile coarse(geographicField(1025, 1025, 512, 46.0, 8.0));
    EXPECT_GT(glm::distance(coarse.position(256, 256), direct(coarse, 46.0, 8.0, 256, 256)), 0.001);
}

TEST(PlacedTile, DefaultOriginIsTheDatasCentreOnTheEllipsoid)
{
    const PlacedTile tile(geographicField(701, 1001, 32, 46.0, 8.0));
    EXPECT_NEAR(tile.frame().origin().latitudeDeg, 46.0 + 500 * kStepDeg, 1e-8);
    EXPECT_NEAR(tile.frame().origin().longitudeDeg, 8.0 + 350 * kStepDeg, 1e-8);
    EXPECT_EQ(tile.frame().origin().heightM, 0.0);
    const glm::dvec3 centre = tile.position(350, 500);
    EXPECT_NEAR(centre.x, 0.0, 0.01);
    EXPECT_NEAR(centre.y, 0.0, 0.01);
    EXPECT_NEAR(centre.z, rolling(350, 500) + 40.0 + 3.5, 0.001);
}

TEST(PlacedTile, OriginAcrossTheAntimeridianIsInTheData)
{
    HeightField field = geographicField(601, 601, 32, -17.0, 179.75);
    for (GeodeticNet::Node& node : field.net->nodes)
        if (node.longitudeDeg > 180.0) node.longitudeDeg -= 360.0;
    const PlacedTile tile(field);
    EXPECT_NEAR(std::abs(tile.frame().origin().longitudeDeg), 180.0, 1e-7);
    EXPECT_LT(glm::length(glm::dvec2(tile.position(300, 300))), 0.1);
}

TEST(PlacedTile, TheEarthCurvesAway)
{
    const PlacedTile tile(geographicField(1025, 1025, 64, 46.0, 8.0), Geodetic{46.0, 8.0, 0.0});
    const glm::dvec3 far = tile.frame().positionAt(1024.0, 1024.0, 0.0);
    const double ground = glm::length(glm::dvec2(far));
    EXPECT_NEAR(far.z, 40.0 + 10.24 - ground * ground / (2.0 * 6.378e6),
                0.02 * ground * ground / (2.0 * 6.378e6));
}

TEST(PlacedTile, APositionHasTheSameBitsHoweverItIsReached)
{
    const PlacedTile tile(geographicField(700, 1025, 16, 46.0, 8.0));
    const PlacedTile again(geographicField(700, 1025, 16, 46.0, 8.0));
    std::mt19937 random(7);
    for (int i = 0; i < 2000; ++i)
    {
        const int c = static_cast<int>(random() % 1025), r = static_cast<int>(random() % 1025);
        const glm::dvec3 p = tile.position(c, r);
        EXPECT_EQ(p, again.position(c, r));
        EXPECT_EQ(p, tile.frame().positionAt(c, r, tile.samples().heightM(c, r)));
    }
}

TEST(PlacedTile, GridAtInvertsPositionAt)
{
    const PlacedTile tile(geographicField(700, 1025, 32, 46.0, 8.0));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-20.0, 1044.0), height(-400.0, 12000.0);
    for (int i = 0; i < 1000; ++i)
    {
        const glm::dvec2 grid(place(random), place(random));
        const glm::dvec2 found = tile.frame().gridAt(tile.frame().positionAt(grid.x, grid.y, height(random)));
        EXPECT_LT(glm::distance(grid, found), 1e-6) << grid.x << " " << grid.y;
    }
}

TEST(PlacedTile, GridNearIsLessThanASampleOff)
{
    const PlacedTile tile(geographicField(1025, 1025, 32, 46.0, 8.0));
    std::mt19937 random(12);
    std::uniform_real_distribution<double> place(0.0, 1024.0), height(0.0, 4000.0);
    double farthest = 0.0;
    for (int i = 0; i < 1000; ++i)
    {
        const glm::dvec2 grid(place(random), place(random));
        const glm::dvec2 found =
            tile.frame().gridNear(glm::dvec2(tile.frame().positionAt(grid.x, grid.y, height(random))));
        farthest = std::max(farthest, glm::distance(grid, found));
    }
    EXPECT_LT(farthest, 1.0);
    const glm::dvec2 flat = tile.frame().positionAt(512.0, 512.0, 0.0),
                     corner = tile.frame().positionAt(0.0, 0.0, 0.0);
    const glm::dvec2 alongEast = tile.frame().positionAt(513.0, 512.0, 0.0),
                     alongNorth = tile.frame().positionAt(512.0, 513.0, 0.0);
    const glm::dvec2 linear =
        glm::inverse(glm::dmat2(alongEast - flat, alongNorth - flat)) * (corner - flat) + 512.0;
    EXPECT_GT(glm::length(linear), 2.0) << "the first order alone would do: nothing was tested";
}

TEST(PlacedTile, GeodeticAndLocalAreInverse)
{
    const PlacedTile tile(geographicField(33, 33, 8, 46.0, 8.0), Geodetic{46.2, 8.1, 300.0});
    const glm::dvec3 local = tile.frame().localFromGeodetic({46.21, 8.12, 1234.5});
    const Geodetic back = tile.frame().geodeticFromLocal(local);
    EXPECT_NEAR(back.latitudeDeg, 46.21, 1e-12);
    EXPECT_NEAR(back.longitudeDeg, 8.12, 1e-12);
    EXPECT_NEAR(back.heightM, 1234.5, 1e-7);
    EXPECT_LT(glm::length(tile.frame().localFromGeodetic(tile.frame().origin())), 1e-8);
}

} // namespace
