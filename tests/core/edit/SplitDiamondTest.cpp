// SPDX-License-Identifier: Apache-2.0
// Compares the diamond of a vertex, found from its grid coordinates alone, with a walk down the bintree.
#include <map>
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/SplitDiamond.h>

namespace
{

using namespace osgTerrainROAM::core;

using Corners = std::array<std::pair<int, int>, 3>;

Corners cornersOf(const GridTriangle& t)
{
    return {{{t.apex.column, t.apex.row}, {t.left.column, t.left.row}, {t.right.column, t.right.row}}};
}

/// By vertex, from the bintree: the triangles that it splits, and their level.
struct Vertices
{
    struct Vertex
    {
        int level = -1;
        std::set<Corners> triangles;
    };
    std::map<std::pair<int, int>, Vertex> all;

    explicit Vertices(int side)
    {
        for (const GridTriangle& root : rootTriangles(side))
            visit(root, 0);
    }

    void visit(const GridTriangle& t, int level)
    {
        const GridPoint mid = t.middleOfBase();
        if (mid == t.left || (t.left.column + t.right.column) % 2 != 0 || (t.left.row + t.right.row) % 2 != 0)
            return;
        Vertex& vertex = all[{mid.column, mid.row}];
        vertex.level = level;
        vertex.triangles.insert(cornersOf(t));
        for (const GridTriangle& child : t.children())
            visit(child, level + 1);
    }
};

TEST(SplitDiamond, IsWhatTheBintreeSays)
{
    constexpr int kGridSide = 33;
    const Vertices vertices(kGridSide);
    EXPECT_EQ(vertices.all.size(), static_cast<std::size_t>(kGridSide) * kGridSide - 4);
    for (const auto& [place, vertex] : vertices.all)
    {
        const SplitDiamond diamond({place.first, place.second}, kGridSide);
        EXPECT_EQ(diamond.level(), vertex.level) << place.first << ", " << place.second;
        std::set<Corners> triangles;
        diamond.forEachTriangle([&](const GridTriangle& t) { triangles.insert(cornersOf(t)); });
        EXPECT_EQ(triangles, vertex.triangles) << place.first << ", " << place.second;
    }
}

/// Twice the area of the largest triangles does not fit into 32 bits.
TEST(SplitDiamond, TheLargestTrianglesAreCounterClockwise)
{
    constexpr int kGridSide = (1 << 16) + 1;
    int triangles = 0;
    SplitDiamond({kGridSide / 2, kGridSide / 2}, kGridSide)
        .forEachTriangle(
            [&](const GridTriangle& t)
            {
                const auto across = [&](GridPoint p)
                { return static_cast<double>(p.column - t.apex.column); };
                const auto up = [&](GridPoint p) { return static_cast<double>(p.row - t.apex.row); };
                EXPECT_EQ(across(t.left) * up(t.right) - up(t.left) * across(t.right), 0x1p32);
                ++triangles;
            });
    EXPECT_EQ(triangles, 2);
}

TEST(SplitDiamond, ParentsAndChildrenAgree)
{
    constexpr int kGridSide = 17;
    std::set<std::array<int, 4>> down, up;
    for (const auto& at : Vertices(kGridSide).all)
    {
        const auto& place = at.first;
        const SplitDiamond diamond({place.first, place.second}, kGridSide);
        diamond.forEachChild([&](GridPoint c) { down.insert({place.first, place.second, c.column, c.row}); });
        diamond.forEachParent([&](GridPoint p) { up.insert({p.column, p.row, place.first, place.second}); });
    }
    EXPECT_EQ(down, up);
    EXPECT_GT(down.size(), 400u);
}

} // namespace
