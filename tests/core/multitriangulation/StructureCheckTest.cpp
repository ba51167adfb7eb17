// SPDX-License-Identifier: Apache-2.0
#include <functional>

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

} // namespace

} // namespace osgMultiTriangulation::core
