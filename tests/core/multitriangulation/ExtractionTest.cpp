// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>
#include <osgMultiTriangulation/core/extract/Extraction.h>

#include "CheckedForest.h"
#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

/// Hills with a multi-triangulation of them.
struct ExtractionCase
{
    SurfaceMesh mesh = testsupport::hillSurface(60, 70);
    ForestTree main{buildTree(fullMesh(mesh)).tree, kNone, {}};
    testsupport::CheckedSurface checked{mesh};
};

auto above(float toleranceM)
{
    return [toleranceM](const MultiTriangulation& tree, std::uint32_t t)
    { return tree.errors[t] > toleranceM; };
}

/// More detail near a place, in steps of the plan.
auto nearPlace(double x, double y)
{
    return [x, y](const MultiTriangulation& tree, std::uint32_t t)
    {
        const SurfacePoint& p = tree.points[tree.corners[t][0]];
        const double distance = std::abs(p.x - x) + std::abs(p.y - y);
        return tree.errors[t] > 0.2 * distance;
    };
}

TEST(Extraction, everyToleranceGivesATriangulationWithinIt)
{
    const ExtractionCase here;
    std::size_t least = 0;
    for (const float tolerance : {40.0f, 10.0f, 3.0f, 1.0f, 0.3f, 0.0f})
    {
        Extraction extraction(here.main);
        EXPECT_EQ(here.checked.fault(extraction), std::nullopt) << "the root";
        extraction.refine(above(tolerance));
        EXPECT_EQ(here.checked.fault(extraction), std::nullopt) << tolerance;
        for (const InTree& at : extraction.active())
            EXPECT_LE(here.main.part.errors[at.number], tolerance);
        EXPECT_GE(extraction.active().size(), least);
        least = extraction.active().size();
    }
}

TEST(Extraction, theFinestIsTheInputAndTheCoarsestTheRoot)
{
    const ExtractionCase here;
    Extraction extraction(here.main);
    extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
    EXPECT_EQ(extraction.active().size(), here.mesh.triangles.size());
    SurfaceMesh drawn = extraction.mesh(), input = here.mesh;
    const auto byPlace = [](const SurfacePoint& a, const SurfacePoint& b)
    { return std::pair(a.x, a.y) < std::pair(b.x, b.y); };
    std::ranges::sort(drawn.points, byPlace);
    std::ranges::sort(input.points, byPlace);
    EXPECT_EQ(drawn.points, input.points);
    extraction.coarsen([](const MultiTriangulation&, std::uint32_t) { return false; });
    EXPECT_EQ(extraction.active().size(), here.main.part.rootTriangles);
}

TEST(Extraction, followsAMovingPlaceAndStandsStillWithIt)
{
    const ExtractionCase here;
    Extraction extraction(here.main);
    for (int step = 0; step < 40; ++step)
    {
        const auto criterion = nearPlace(2.0 + 1.3 * step, 60.0 - step);
        extraction.update(criterion);
        ASSERT_EQ(here.checked.fault(extraction), std::nullopt) << step;
        for (const InTree& at : extraction.active())
            EXPECT_FALSE(criterion(here.main.part, at.number) && here.main.part.lower[at.number] != kNone);
        const std::uint64_t before = extraction.changes();
        extraction.update(criterion);
        EXPECT_EQ(extraction.changes(), before);
    }
}

TEST(Extraction, theCheckFindsWhatIsWrong) // mutations of a valid triangulation
{
    ExtractionCase here;
    Extraction extraction(here.main);
    extraction.refine(above(3.0f));
    const SurfaceMesh good = extraction.mesh();
    ASSERT_EQ(checkSurface(good, here.checked.outline), std::nullopt);

    SurfaceMesh hole = good;
    hole.triangles.erase(hole.triangles.begin() + 20);
    EXPECT_NE(checkSurface(hole, here.checked.outline), std::nullopt);

    SurfaceMesh turned = good;
    std::swap(turned.triangles[7][0], turned.triangles[7][1]);
    EXPECT_NE(checkSurface(turned, here.checked.outline), std::nullopt);

    SurfaceMesh doubled = good;
    doubled.triangles.push_back(doubled.triangles[3]);
    EXPECT_NE(checkSurface(doubled, here.checked.outline), std::nullopt);

    SurfaceMesh crack = good; // a corner of one triangle alone moves
    SurfacePoint moved = crack.points[crack.triangles[30][0]];
    moved.x += moved.x < 30 ? 1 : -1;
    crack.points.push_back(moved);
    crack.triangles[30][0] = static_cast<std::uint32_t>(crack.points.size() - 1);
    EXPECT_NE(checkSurface(crack, here.checked.outline), std::nullopt);

    for (float& error : here.main.part.errors) // bounds that are too small by a tenth
        error *= 0.9f;
    EXPECT_NE(here.checked.fault(extraction), std::nullopt);
}

} // namespace

} // namespace osgMultiTriangulation::core
