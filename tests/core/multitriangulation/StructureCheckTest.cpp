// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <functional>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgMultiTriangulation/core/build/BuildTree.h>
#include <osgMultiTriangulation/core/check/StructureCheck.h>

#include "HillSurface.h"

namespace osgMultiTriangulation::core
{

namespace
{

TEST(StructureCheck, findsEachDamage)
{
    const MultiTriangulation good = buildTree(fullMesh(testsupport::hillSurface(20, 20))).tree;
    ASSERT_EQ(checkStructure(good), std::nullopt);
    const std::uint32_t middle = good.triangleCount() / 2;
    const std::vector<std::pair<const char*, std::function<void(MultiTriangulation&)>>> damages{
        {"a corner", [&](MultiTriangulation& tree) { --tree.corners[middle][1]; }},
        {"a corner that does not exist", [&](MultiTriangulation& tree) { tree.corners[middle][1] = 400; }},
        {"orientation",
         [&](MultiTriangulation& tree) { std::swap(tree.corners[middle][0], tree.corners[middle][1]); }},
        {"a floor", [&](MultiTriangulation& tree) { std::swap(tree.floors[40], tree.floors[90]); }},
        {"a floor that does not exist",
         [&](MultiTriangulation& tree) { tree.floors[40] = tree.triangleCount(); }},
        {"a lower link", [&](MultiTriangulation& tree) { tree.lower[0] = kNone; }},
        {"an upper link", [&](MultiTriangulation& tree) { tree.upper[middle] = 0; }},
        {"an error", [&](MultiTriangulation& tree) { tree.errors[middle] = -1.0f; }},
        {"a point", [&](MultiTriangulation& tree) { tree.points.pop_back(); }},
        {"a count", [&](MultiTriangulation& tree) { ++tree.fragments[30].triangleCount; }},
        {"a list", [&](MultiTriangulation& tree) { tree.errors.pop_back(); }},
        {"the vertex of a fragment",
         [&](MultiTriangulation& tree) { std::swap(tree.points[tree.rootPoints], tree.points.back()); }},
    };
    for (const auto& [name, damage] : damages)
    {
        MultiTriangulation bad = good;
        damage(bad);
        EXPECT_NE(checkStructure(bad), std::nullopt) << name;
    }
}

/// The sides of triangles that have no neighbour among them.
using Outline = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Outline outlineOf(const std::vector<Triangle>& triangles, std::uint32_t subset)
{
    Outline outline;
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (int c = 0; (subset >> t & 1) != 0 && c < 3; ++c)
            if (const std::pair side{triangles[t][c], triangles[t][(c + 1) % 3]};
                outline.erase({side.second, side.first}) == 0)
                outline.insert(side);
    return outline;
}

/// Whether no part of a star but the whole has the outline of a part of its floor: then the fragment cannot
/// be cut in two that could be applied one without the other. Tries all parts of both.
bool isMinimallyCompatible(const std::vector<Triangle>& star, const std::vector<Triangle>& floor)
{
    std::set<Outline> ofFloor;
    for (std::uint32_t subset = 1; subset < 1u << floor.size(); ++subset)
        ofFloor.insert(outlineOf(floor, subset));
    for (std::uint32_t subset = 1; subset + 1 < 1u << star.size(); ++subset)
        if (ofFloor.contains(outlineOf(star, subset))) return false;
    return true;
}

TEST(StructureCheck, eachFragmentIsMinimallyCompatible)
{
    constexpr std::size_t kMostTried = 9; // triangles of a star: 512 parts
    const MultiTriangulation tree = buildTree(fullMesh(testsupport::hillSurface(24, 24))).tree;
    ASSERT_EQ(checkStructure(tree), std::nullopt);
    std::size_t tried = 0, joined = 0;
    std::vector<Triangle> starBefore, floorBefore;
    for (std::uint32_t f = 0; f < tree.fragments.size(); ++f)
    {
        const Fragment& own = tree.fragments[f];
        if (own.triangleCount > kMostTried) continue;
        const auto first = tree.corners.begin() + own.firstTriangle;
        std::vector<Triangle> star(first, first + own.triangleCount), floor;
        for (const std::uint32_t t : tree.floorOf(f))
            floor.push_back(tree.corners[t]);
        EXPECT_TRUE(isMinimallyCompatible(star, floor)) << "fragment " << f;
        ++tried;
        // The mutation: two fragments as one, which can be cut in two again.
        const std::vector<Triangle> alone = star;
        star.insert(star.end(), starBefore.begin(), starBefore.end());
        floor.insert(floor.end(), floorBefore.begin(), floorBefore.end());
        if (own.triangleCount == own.floorCount + 2 && star.size() > alone.size() &&
            star.size() <= kMostTried)
        {
            EXPECT_FALSE(isMinimallyCompatible(star, floor)) << "fragment " << f << " and another";
            ++joined;
        }
        starBefore = alone;
        floorBefore.clear();
        for (const std::uint32_t t : tree.floorOf(f))
            floorBefore.push_back(tree.corners[t]);
    }
    EXPECT_GT(tried, tree.fragments.size() / 2);
    EXPECT_GT(joined, 5u);
}

} // namespace

} // namespace osgMultiTriangulation::core
