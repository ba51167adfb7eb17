// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/check/ErrorCheck.h>
#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/check/SurfaceCheck.h>

#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

float greatestRootError(const MultiTriangulation& tree)
{
    return *std::max_element(tree.errors.begin(), tree.errors.begin() + tree.rootTriangles);
}

SurfaceMesh rootOf(const MultiTriangulation& tree)
{
    SurfaceMesh root{tree.points, {}};
    root.triangles.assign(tree.corners.begin(), tree.corners.begin() + tree.rootTriangles);
    return root;
}

TEST(BuildTree, aPlaneBecomesTwoTrianglesWithoutError)
{
    std::vector<float> heights;
    for (int i = 0; i < 20 * 30; ++i)
        heights.push_back(static_cast<float>(2 * (i % 20) + 3 * (i / 20)));
    const BuiltTree built = buildTree(fullMesh(gridSurface(20, 30, heights)));
    EXPECT_EQ(built.tree.rootTriangles, 2u);
    EXPECT_EQ(built.tree.fragments.size(), 20u * 30u - 4u);
    EXPECT_EQ(*std::ranges::max_element(built.tree.errors), 0.0f);
    EXPECT_EQ(checkStructure(built.tree), std::nullopt);
}

TEST(BuildTree, aPeakIsTheErrorOfTheRootAndReturnsFirst)
{
    std::vector<float> heights(5 * 5, 0.0f);
    heights[12] = 7.0f;
    const BuiltTree built = buildTree(fullMesh(gridSurface(5, 5, heights)));
    EXPECT_EQ(built.tree.rootTriangles, 2u);
    EXPECT_EQ(greatestRootError(built.tree), 7.0f);
    EXPECT_EQ(built.tree.points[built.tree.rootPoints], (SurfacePoint{2, 2, 7.0}));
}

TEST(BuildTree,
     theHoleIsFilledWithTheLeastError) // a ridge along y = x: the diagonal along it leaves no error
{
    const SurfaceMesh mesh{{{0, 0, 0.0}, {8, 0, -9.0}, {8, 8, 0.0}, {0, 8, -9.0}, {4, 4, 0.0}},
                           {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
    const BuiltTree built = buildTree(fullMesh(mesh));
    ASSERT_EQ(built.tree.rootTriangles, 2u);
    EXPECT_EQ(greatestRootError(built.tree), 0.0f);
}

TEST(BuildTree, theDrainIsTheInput)
{
    const SurfaceMesh mesh = testsupport::hillSurface(40, 33);
    const BuiltTree built = buildTree(fullMesh(mesh));
    ASSERT_EQ(checkStructure(built.tree), std::nullopt);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
        const std::uint32_t number = built.triangle[t];
        EXPECT_EQ(built.tree.lower[number], kNone);
        EXPECT_EQ(built.tree.errors[number], 0.0f);
        Triangle own = mesh.triangles[t],
                 drawn = built.tree.corners[number]; // stars begin where their ring does
        for (std::uint32_t& corner : drawn)
            corner = built.points[corner];
        std::rotate(own.begin(), std::ranges::min_element(own), own.end());
        std::rotate(drawn.begin(), std::ranges::min_element(drawn), drawn.end());
        EXPECT_EQ(drawn, own);
    }
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
        EXPECT_EQ(built.tree.points[p], mesh.points[built.points[p]]);
    EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(built.tree.lower, kNone)), mesh.triangles.size());
}

TEST(BuildTree, lockedPointsStayAndKeepIsKept)
{
    const SurfaceMesh mesh = testsupport::hillSurface(33, 33);
    TreeOptions options;
    options.isLocked.assign(mesh.points.size(), false);
    for (int i = 0; i < 33; ++i)
        options.isLocked[17 * 33 + i] = true;
    options.keep = 300;
    const BuiltTree some = buildTree(fullMesh(mesh), options);
    EXPECT_EQ(some.tree.rootPoints, 300u);
    options.keep = 0;
    const BuiltTree all = buildTree(fullMesh(mesh), options);
    EXPECT_LE(all.tree.rootPoints, 33u + 4u + 12u); // those with too many neighbours stay
    for (std::uint32_t p = all.tree.rootPoints; p < all.tree.points.size(); ++p)
        EXPECT_NE(all.tree.points[p].y, 17);
    EXPECT_EQ(checkSurface(rootOf(all.tree), outlineOf(mesh)), std::nullopt);
}

TEST(BuildTree, simplifyingInTwoStepsStillKnowsEveryPoint)
{
    const SurfaceMesh mesh = testsupport::hillSurface(50, 50);
    TreeOptions options;
    options.keep = 900;
    const BuiltTree first = buildTree(fullMesh(mesh), options);
    EXPECT_EQ(first.rest.hidden.size(), 50u * 50u - 900u);
    const BuiltTree second = buildTree(first.rest);
    EXPECT_EQ(second.rest.hidden.size(), 50u * 50u - 4u);
    const MeasuredMesh& rest = second.rest;
    const PointCells cells(mesh.points);
    EXPECT_LE(cells.greatestExcess(rest.mesh, rest.errors), 1e-6);
    EXPECT_NEAR(cells.greatestExcess(rest.mesh, std::vector<float>(rest.errors.size(), 0.0f)),
                *std::ranges::max_element(rest.errors), 5e-4 * *std::ranges::max_element(rest.errors))
        << "not exact";
}

TEST(BuildTree, twoRunsAreEqual)
{
    const SurfaceMesh mesh = testsupport::hillSurface(40, 40);
    EXPECT_EQ(buildTree(fullMesh(mesh)).tree, buildTree(fullMesh(mesh)).tree);
}

} // namespace

} // namespace osgMultiTriangulation::core
