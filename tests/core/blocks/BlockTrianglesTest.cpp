// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/blocks/BlockTriangles.h>
#include <osgTerrainROAM/core/roam/PlanTriangle.h>

namespace
{

using namespace osgTerrainROAM::core;

constexpr int kExponent = 4, kLast = 1 << kExponent;

/// Calls visit(shape) for every level and every combination of borders.
template<class Visit>
void forEachShape(const Visit& visit)
{
    for (int level = 0; level <= kExponent; ++level)
    {
        const int choices = kExponent - level + 1;
        for (int code = 0; code < choices * choices * choices * choices; ++code)
        {
            BlockShape shape{level, {}};
            for (int side = 0, rest = code; side < kSides; ++side, rest /= choices)
                shape.borders[static_cast<std::size_t>(side)] = level + rest % choices;
            visit(shape);
        }
    }
}

std::int64_t doubleArea(const std::vector<BlockTriangle>& triangles)
{
    std::int64_t area = 0;
    for (const BlockTriangle& t : triangles)
        area += PlanTriangle{t}.doubleArea();
    return area;
}

using Edge = std::pair<std::pair<int, int>, std::pair<int, int>>;

/// The edges that no other triangle shares, by both ends.
std::vector<Edge> openEdges(const std::vector<BlockTriangle>& triangles)
{
    std::map<Edge, int> edges;
    for (const BlockTriangle& t : triangles)
        for (std::size_t i = 0; i < 3; ++i)
        {
            const auto from = std::pair(t[i].column, t[i].row);
            const auto to = std::pair(t[(i + 1) % 3].column, t[(i + 1) % 3].row);
            ++edges[{from, to}];
            --edges[{to, from}];
        }
    std::vector<Edge> open;
    for (const auto& [edge, count] : edges)
        if (count > 0) open.push_back(edge);
    return open;
}

/// Whether the outline is that of the borders' levels: every edge of a side as long as its level says.
bool hasBorders(const std::vector<BlockTriangle>& triangles, const BlockShape& shape)
{
    const auto open = openEdges(triangles);
    std::size_t wanted = 0;
    for (int side = 0; side < kSides; ++side)
    {
        const int step = 1 << shape.borders[static_cast<std::size_t>(side)];
        wanted += static_cast<std::size_t>(kLast / step);
        for (int at = 0; at < kLast; at += step)
        {
            const std::pair<int, int> along[kSides][2] = {{{at, 0}, {at + step, 0}},
                                                          {{kLast, at}, {kLast, at + step}},
                                                          {{kLast - at, kLast}, {kLast - at - step, kLast}},
                                                          {{0, kLast - at}, {0, kLast - at - step}}};
            if (std::find(open.begin(), open.end(), Edge{along[side][0], along[side][1]}) == open.end())
                return false;
        }
    }
    return open.size() == wanted;
}

TEST(BlockTriangles, CoverTheBlockWithTheBordersThatTheyShouldHave)
{
    std::size_t shapes = 0;
    forEachShape(
        [&](const BlockShape& shape)
        {
            const auto triangles = trianglesOf(kExponent, shape, {0, 0});
            ++shapes;
            ASSERT_EQ(triangles.size(), triangleCount(kExponent, shape));
            ASSERT_EQ(doubleArea(triangles), 2 * kLast * kLast);
            for (const BlockTriangle& t : triangles)
                ASSERT_GT(PlanTriangle{t}.doubleArea(), 0);
            ASSERT_TRUE(hasBorders(triangles, shape)) << shape.level;
        });
    EXPECT_GT(shapes, 900u);
}

TEST(BlockTriangles, AVertexTooManyIsNoticed)
{
    const BlockShape shape{0, {0, 2, 0, 0}};
    EXPECT_FALSE(hasBorders(trianglesOf(kExponent, {0, {0, 1, 0, 0}}, {0, 0}), shape));
    auto triangles = trianglesOf(kExponent, shape, {0, 0});
    triangles.pop_back();
    EXPECT_FALSE(hasBorders(triangles, shape));
}

/// Whether a triangle lies in one of others.
bool liesInOne(const BlockTriangle& t, const std::vector<BlockTriangle>& others)
{
    return std::any_of(others.begin(), others.end(),
                       [&](const BlockTriangle& other)
                       {
                           const PlanTriangle plan{other};
                           return plan.holds(t[0]) && plan.holds(t[1]) && plan.holds(t[2]);
                       });
}

TEST(BlockTriangles, ALevelRefinesTheNextOneAndABorderTheNextBorder)
{
    // What morphing needs, for all states whose levels differ by one at most.
    for (const GridPoint origin : {GridPoint{0, 0}, GridPoint{kLast, 0}, GridPoint{kLast, kLast}})
        for (int level = 0; level < kExponent; ++level)
            for (int coarse = 0; coarse < 16; ++coarse)
            {
                BlockShape shape{level, {level, level, level, level}}, next{level + 1, {}};
                for (std::size_t side = 0; side < kSides; ++side)
                {
                    shape.borders[side] = level + (coarse >> side & 1);
                    next.borders[side] = level + 1;
                }
                const auto same = trianglesOf(kExponent, {level, {level, level, level, level}}, origin);
                const auto fine = trianglesOf(kExponent, shape, origin),
                           coarser = trianglesOf(kExponent, next, origin);
                for (const BlockTriangle& t : same)
                    ASSERT_TRUE(liesInOne(t, fine));
                if (coarse != 15) continue;
                for (const BlockTriangle& t : fine)
                    ASSERT_TRUE(liesInOne(t, coarser)) << level;
            }
    // Not so where a border goes on from the next level: with morphing, levels differ by one at most.
    const auto fine = trianglesOf(kExponent, {0, {1, 1, 1, 1}}, {0, 0});
    const auto coarser = trianglesOf(kExponent, {0, {2, 2, 2, 2}}, {0, 0});
    EXPECT_FALSE(
        std::all_of(fine.begin(), fine.end(), [&](const BlockTriangle& t) { return liesInOne(t, coarser); }));
}

} // namespace
