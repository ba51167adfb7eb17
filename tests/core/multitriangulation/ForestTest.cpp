// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/check/StructureCheck.h>
#include <osgMultiTriangulation/core/split/BuildForest.h>

#include "CheckedForest.h"
#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

Forest forestOf(const SurfaceMesh& mesh, std::uint32_t rectangles, unsigned jobs = 1)
{
    ForestOptions options;
    options.treeCount = rectangles;
    options.jobs = jobs;
    return buildForest(mesh, options)->forest;
}

std::size_t trianglesWithin(const Forest& forest, float toleranceM)
{
    Extraction extraction(forest.trees[0]);
    for (std::uint32_t t = 1; t < forest.trees.size(); ++t)
        extraction.attach(t, forest.trees[t]);
    extraction.refine([&](const MultiTriangulation& tree, std::uint32_t t)
                      { return tree.errors[t] > toleranceM; });
    return extraction.active().size();
}

TEST(Forest, hangsTogetherAndItsDrainIsTheInput)
{
    const SurfaceMesh mesh = testsupport::hillSurface(90, 70);
    const Forest forest = forestOf(mesh, 11);
    EXPECT_GE(forest.trees.size(), 15u);
    EXPECT_EQ(checkStructure(forest), std::nullopt);
    Extraction extraction(forest.trees[0]);
    for (std::uint32_t t = 1; t < forest.trees.size(); ++t)
        extraction.attach(t, forest.trees[t]);
    extraction.refine([](const MultiTriangulation&, std::uint32_t) { return true; });
    const auto keys =
        [](const SurfaceMesh& of) // each triangle by its places and heights, from the lowest place on
    {
        std::vector<std::array<double, 9>> all;
        for (Triangle t : of.triangles)
        {
            const auto place = [&](std::uint32_t c) { return std::pair(of.points[c].x, of.points[c].y); };
            std::rotate(t.begin(), std::ranges::min_element(t, {}, place), t.end());
            std::array<double, 9> key{};
            for (int c = 0; c < 3; ++c)
            {
                key[3 * c] = of.points[t[c]].x;
                key[3 * c + 1] = of.points[t[c]].y;
                key[3 * c + 2] = of.points[t[c]].height;
            }
            all.push_back(key);
        }
        std::ranges::sort(all);
        return all;
    };
    EXPECT_EQ(keys(extraction.mesh()), keys(mesh));
}

TEST(Forest, doesNotDependOnThreads)
{
    const SurfaceMesh mesh = testsupport::hillSurface(64, 64);
    EXPECT_EQ(forestOf(mesh, 9, 1).trees, forestOf(mesh, 9, 4).trees);
}

TEST(Forest, bordersOfTreesAreNotFrozen)
{
    const SurfaceMesh mesh = testsupport::hillSurface(129, 129);
    const Forest whole{{ForestTree{buildTree(fullMesh(mesh)).tree, kNone, {}}}};
    const Forest split = forestOf(mesh, 8);
    for (const float tolerance : {2.0f, 5.0f, 15.0f})
        EXPECT_LE(trianglesWithin(split, tolerance), 1.08 * trianglesWithin(whole, tolerance)) << tolerance;
}

TEST(Forest, everyMixtureOfLoadedTreesGivesATriangulation)
{
    const SurfaceMesh mesh = testsupport::hillSurface(80, 80);
    const Forest forest = forestOf(mesh, 9);
    const testsupport::CheckedSurface checked(mesh);
    Extraction extraction(forest.trees[0]);
    testsupport::Random random(3);
    for (int step = 0; step < 60; ++step)
    {
        const std::uint32_t t = 1 + random.below(static_cast<std::uint32_t>(forest.trees.size() - 1));
        const bool hasChild = std::ranges::any_of(
            forest.trees,
            [&](const ForestTree& tree)
            {
                return tree.parent == t &&
                       extraction.isAttached(static_cast<std::uint32_t>(&tree - forest.trees.data()));
            });
        if (!extraction.isAttached(t) && extraction.isAttached(forest.trees[t].parent))
            extraction.attach(t, forest.trees[t]);
        else if (extraction.isAttached(t) && !hasChild)
            extraction.detach(t);
        const auto tolerance = static_cast<float>(6.0 * random.unit());
        extraction.update([&](const MultiTriangulation& tree, std::uint32_t at)
                          { return tree.errors[at] > tolerance; });
        ASSERT_EQ(checked.fault(extraction), std::nullopt) << step;
    }
}

TEST(Forest, aStoppedBuildSaysSo)
{
    ForestOptions options;
    options.treeCount = 8;
    options.progress = [](std::uint32_t done, std::uint32_t) { return done < 3; };
    const auto built = buildForest(testsupport::hillSurface(40, 40), options);
    ASSERT_FALSE(built);
    EXPECT_NE(built.error().message().find("stopped"), std::string::npos);
}

TEST(Forest, theCheckFindsTreesThatHangWrong)
{
    const Forest good = forestOf(testsupport::hillSurface(40, 40), 4);
    ASSERT_EQ(checkStructure(good), std::nullopt);
    Forest bad = good;
    std::swap(bad.trees.back().parentTriangles[0], bad.trees.back().parentTriangles[1]);
    EXPECT_NE(checkStructure(bad), std::nullopt) << "two triangles are exchanged";
    bad = good;
    bad.trees.back().parent = 0;
    EXPECT_NE(checkStructure(bad), std::nullopt) << "another parent";
    bad = good;
    bad.trees.back().part.errors[0] *= 2.0f;
    bad.trees.back().part.errors[0] += 1.0f;
    EXPECT_NE(checkStructure(bad), std::nullopt) << "another error";
    bad = good;
    bad.trees.back().part.points[0].height += 0.5;
    EXPECT_NE(checkStructure(bad), std::nullopt) << "a point moved";
}

} // namespace

} // namespace osgMultiTriangulation::core
