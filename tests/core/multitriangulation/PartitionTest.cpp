// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/split/BorderFit.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>
#include <osgMultiTriangulation/core/split/Partition.h>
#include <osgMultiTriangulation/core/split/TreeCount.h>

#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

TEST(Partition, sixteenPointsBecomeFourSquares) // by hand
{
    const SurfaceMesh mesh = testsupport::hillSurface(4, 4);
    const Partition partition = partitionPoints(mesh.points, 4.0);
    EXPECT_EQ(partition.rectangles, 4u);
    EXPECT_EQ(partition.parts.size(), 7u);
    const auto at = [&](int column, int row) { return partition.partAt(mesh.points[row * 4 + column]); };
    EXPECT_EQ(at(0, 0), at(1, 1));
    EXPECT_EQ(at(2, 2), at(3, 3));
    EXPECT_NE(at(1, 1), at(2, 1));
    EXPECT_NE(at(1, 1), at(1, 2));
    EXPECT_EQ(partition.common(at(0, 0), at(3, 3)), 0u);
    EXPECT_EQ(partition.common(at(0, 0), at(1, 1)), at(0, 0));
}

TEST(Partition, rectanglesAreNearTheirTarget)
{
    testsupport::Random random(4);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 20000; ++i) // crowded in one corner
        points.push_back({static_cast<std::int32_t>(1e6 * random.unit() * random.unit() * random.unit()),
                          static_cast<std::int32_t>(1e6 * random.unit() * random.unit()), 0.0});
    for (const SplitAt where : {SplitAt::centre, SplitAt::median})
    {
        const Partition partition = partitionPoints(points, 500.0, where);
        std::uint32_t sum = 0;
        for (const PlanPart& part : partition.parts)
            if (part.isWhole())
            {
                EXPECT_LE(part.points, 667u);
                sum += part.points;
            }
            else
                EXPECT_GT(part.points, 667u);
        EXPECT_EQ(sum, 20000u);
    }
}

TEST(Partition, pointsAtOnePlaceAreNotDivided)
{
    const std::vector<SurfacePoint> points(100, SurfacePoint{5, 5, 0.0});
    EXPECT_EQ(partitionPoints(points, 10.0).rectangles, 1u);
    std::vector<SurfacePoint> line;
    for (int i = 0; i < 100; ++i)
        line.push_back({7, i, 0.0});
    EXPECT_GE(partitionPoints(line, 10.0).rectangles, 8u);
}

TEST(TreeCount, balancesPartsAndBorders)
{
    const BorderModel model{4.0, 0.5};
    const double points = 1e6, count = balancedTreeCount(points, model);
    EXPECT_NEAR(count, 40.0, 1.0);
    EXPECT_NEAR(model.c * std::pow(points / count, model.a) * count / (points / count), 1.0, 0.05);
    EXPECT_EQ(balancedTreeCount(1e6, {2.0, 1.0 / 3.0}),
              static_cast<std::uint32_t>(std::ceil(std::pow(1e12 / 8.0, 0.2))))
        << "the paper's formula";
    EXPECT_EQ(balancedTreeCount(3.0), 1u);
}

TEST(TreeCount, followsTheBordersOfTheInput)
{
    EXPECT_EQ(fitBorder(testsupport::hillSurface(3, 3)).c, BorderModel{}.c) << "one rectangle: no border";
    const SurfaceMesh square = testsupport::hillSurface(120, 120);
    const SurfaceMesh strip = testsupport::hillSurface(1440, 10);
    const double ofSquare = fitBorder(square).c, ofStrip = fitBorder(strip).c;
    EXPECT_GT(ofSquare, 2.0);
    EXPECT_LT(ofSquare, 5.0);
    EXPECT_LT(ofStrip, 0.5 * ofSquare) << "rectangles side by side have two borders";
    for (const SurfaceMesh* mesh : {&square, &strip})
    {
        // As many points on all borders as in a rectangle, as near as halving gets.
        const auto built = buildForest(*mesh);
        ASSERT_TRUE(built);
        const double rectangles = built->report.rectangles;
        const double ratio =
            built->report.borderPoints * rectangles / (static_cast<double>(mesh->points.size()) / rectangles);
        EXPECT_GT(ratio, 0.3);
        EXPECT_LT(ratio, 3.5);
    }
    ForestOptions unfitted;
    unfitted.border = BorderModel{};
    const auto built = buildForest(strip, unfitted); // the control
    ASSERT_TRUE(built);
    const double rectangles = built->report.rectangles;
    EXPECT_LT(built->report.borderPoints * rectangles * rectangles / 14400.0, 0.3);
}

} // namespace

} // namespace osgMultiTriangulation::core
