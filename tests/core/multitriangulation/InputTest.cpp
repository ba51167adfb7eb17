// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/input/Delaunay.h>
#include <osgMultiTriangulation/core/input/PointDistribution.h>
#include <osgMultiTriangulation/core/input/PointSet.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "CheckedForest.h"
#include "TestFolder.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Positive when p lies within the circle through a, b, c (counter-clockwise). Coordinates below 2^12: exact.
double inCircle(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c, const SurfacePoint& p)
{
    const double ax = a.x - p.x, ay = a.y - p.y, bx = b.x - p.x, by = b.y - p.y, cx = c.x - p.x,
                 cy = c.y - p.y;
    return (ax * ax + ay * ay) * (bx * cy - cx * by) - (bx * bx + by * by) * (ax * cy - cx * ay) +
           (cx * cx + cy * cy) * (ax * by - bx * ay);
}

TEST(Delaunay, noPointLiesInACircleAndTheHullIsCovered)
{
    std::vector<SurfacePoint> points;
    for (const SurfacePoint& p : madeUpPoints(PointDistribution::uniform, 150))
        points.push_back({p.x >> 16, p.y >> 16, p.height});
    for (int i = 0; i < 6; ++i) // squares: four points on one circle
        for (int j = 0; j < 6; ++j)
            points.push_back({2000 + 10 * i, 2000 + 10 * j, 0.0});
    std::ranges::sort(points, {}, [](const SurfacePoint& p) { return std::pair(p.x, p.y); });
    const auto isAtOnePlace = [](const SurfacePoint& p, const SurfacePoint& q)
    { return p.x == q.x && p.y == q.y; };
    points.erase(std::unique(points.begin(), points.end(), isAtOnePlace), points.end());
    const SurfaceMesh mesh = delaunay(points);
    EXPECT_EQ(checkInput(mesh), std::nullopt);
    for (const Triangle& t : mesh.triangles)
        for (const SurfacePoint& p : points)
            ASSERT_LE(inCircle(points[t[0]], points[t[1]], points[t[2]], p), 0.0);
    double area = 0.0;
    for (const Triangle& t : mesh.triangles)
        area += twiceArea(points[t[0]], points[t[1]], points[t[2]]);
    double hull = 0.0; // of the outline, which is convex
    const std::vector<OutlineSide> outline = outlineOf(mesh);
    for (const OutlineSide& side : outline)
    {
        hull += double(side[0]) * side[3] - double(side[2]) * side[1];
        for (const SurfacePoint& p : points)
            ASSERT_GE(twiceArea({side[0], side[1], 0.0}, {side[2], side[3], 0.0}, p), 0.0);
    }
    EXPECT_EQ(area, hull);
}

TEST(Delaunay, pointsOnALineHaveNoTriangle)
{
    EXPECT_TRUE(delaunay({{0, 0, 0.0}, {5, 5, 0.0}, {9, 9, 0.0}}).triangles.empty());
    EXPECT_EQ(delaunay({{0, 0, 0.0}, {5, 0, 0.0}, {0, 5, 0.0}}).triangles.size(), 1u);
}

TEST(PointSet, readsCommasBlanksHeadersAndTellsTheBadLine)
{
    const testsupport::TestFolder folder("points");
    const auto read =
        readPointFile(folder.write("a.csv", "x,y,z\n# measured\n1.5,2,3\n\n4;5;-6.25;class\n7 8\t+9\r\n"));
    ASSERT_TRUE(read) << read.error().message();
    EXPECT_EQ(*read, (std::vector<MeasuredPoint>{{1.5, 2, 3}, {4, 5, -6.25}, {7, 8, 9}}));
    const auto bad = readPointFile(folder.write("b.xyz", "1 2 3\n4 five 6\n"));
    ASSERT_FALSE(bad);
    EXPECT_NE(bad.error().message().find("b.xyz:2: "), std::string::npos);
    EXPECT_FALSE(readPointFile(folder.write("c.xyz", "1 2\n")));
    EXPECT_FALSE(readPointFile(folder.write("d.xyz", "1 2 nan\n")));
    EXPECT_FALSE(readPointFile(folder.write("e.xyz", "1 2 3x\n")));
    EXPECT_FALSE(readPointFile(folder.write("f.xyz", "\n")));
    EXPECT_FALSE(readPointFile(folder.write("g.xyz", "0 0 0\n1e308 0 0\n-1e308 0 0\n"))); // no extent
    EXPECT_TRUE(readPointFile(folder.write("h.xyz", "1e15 0 0\n-1e15 0 0\n")));
    EXPECT_FALSE(readPointFile(folder / "none.xyz"));
}

TEST(PointSet, decimalsAreKeptWhereTheyFit)
{
    const std::vector<MeasuredPoint> points{
        {446123.12, 5412345.5, 1.0}, {446999.99, 5412000.0, 2.0}, {446123.12, 5412345.5, 3.0}};
    const PlacedPoints placed = placeOnLattice(points);
    EXPECT_EQ(placed.repeated, 1u);
    EXPECT_LT(placed.mostMoved, 1e-9);
    EXPECT_NEAR(placed.frame.stepX, 0.01, 1e-12);
    EXPECT_EQ(placed.points, (std::vector<SurfacePoint>{{0, 34550, 1.0}, {87687, 0, 2.0}}));
    const PlacedPoints wide =
        placeOnLattice(std::vector<MeasuredPoint>{{0, 0, 0}, {1e6, 0.001, 0}, {1.0 / 3.0, 7, 0}});
    EXPECT_GT(wide.mostMoved, 0.0);
    EXPECT_LE(wide.mostMoved, 0.5 * wide.frame.stepX * 1.001);
}

TEST(PointSet, everyDistributionBecomesAForestWithinItsBounds)
{
    for (const PointDistribution distribution : {PointDistribution::uniform, PointDistribution::normal,
                                                 PointDistribution::laplace, PointDistribution::clustered})
    {
        const SurfaceMesh mesh = delaunay(madeUpPoints(distribution, 4000));
        ASSERT_EQ(checkInput(mesh), std::nullopt);
        const BuiltForest built = *buildForest(mesh);
        EXPECT_EQ(checkStructure(built.forest), std::nullopt);
        const testsupport::CheckedSurface checked(mesh);
        Extraction extraction(built.forest.trees[0]);
        for (std::uint32_t t = 1; t < built.forest.trees.size(); ++t)
            extraction.attach(t, built.forest.trees[t]);
        for (const float tolerance : {100.0f, 10.0f, 1.0f})
        {
            extraction.refine([&](const MultiTriangulation& tree, std::uint32_t t)
                              { return tree.errors[t] > tolerance; });
            EXPECT_EQ(checked.fault(extraction), std::nullopt) << int(distribution) << ' ' << tolerance;
        }
        extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
        EXPECT_EQ(extraction.active().size(), mesh.triangles.size());
    }
}

} // namespace

} // namespace osgMultiTriangulation::core
