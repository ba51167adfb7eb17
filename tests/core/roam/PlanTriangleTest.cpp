// SPDX-License-Identifier: Apache-2.0
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/PlanTriangle.h>

#include "Random.h"

namespace
{

using namespace osgTerrainROAM::core;

PlanTriangle randomTriangle(testsupport::Random& random, int side)
{
    const auto point = [&] {
        return GridPoint{static_cast<int>(random.unit() * side), static_cast<int>(random.unit() * side)};
    };
    PlanTriangle t{{point(), point(), point()}};
    if (t.doubleArea() < 0) std::swap(t.corners[0], t.corners[1]);
    return t;
}

TEST(PlanTriangle, VisitsThePointsThatItHoldsAndNoOther)
{
    testsupport::Random random(7);
    for (int trial = 0; trial < 2000; ++trial)
    {
        const PlanTriangle t = randomTriangle(random, 24);
        if (t.doubleArea() == 0) continue;
        std::set<std::pair<int, int>> visited;
        const int step = trial % 2 == 0 ? 1 : 4;
        t.forEachRow(
            20, 22,
            [&](int row, int west, int east)
            {
                for (int column = west; column <= east; column += step)
                    visited.emplace(column, row);
            },
            step);
        for (int row = 0; row < 24; ++row)
            for (int column = 0; column < 24; ++column)
                ASSERT_EQ(visited.contains({column, row}), column % step == 0 && row % step == 0 &&
                                                               column < 20 && row < 22 &&
                                                               t.holds({column, row}))
                    << column << ' ' << row;
    }
}

TEST(PlanTriangle, CoordinatesGiveThePointBack)
{
    testsupport::Random random(8);
    for (int trial = 0; trial < 500; ++trial)
    {
        const PlanTriangle t = randomTriangle(random, 100);
        if (t.doubleArea() == 0) continue;
        const auto b = t.at(13, 57);
        const auto& [c0, c1, c2] = t.corners;
        EXPECT_NEAR(c0.column + b.u * (c1.column - c0.column) + b.w * (c2.column - c0.column), 13.0, 1e-9);
        EXPECT_NEAR(c0.row + b.u * (c1.row - c0.row) + b.w * (c2.row - c0.row), 57.0, 1e-9);
    }
}

TEST(PlanTriangle, AgreesWithTheTrianglesOfTheBintree)
{
    const GridTriangle bintree{{8, 8}, {12, 12}, {4, 12}};
    const PlanTriangle plan{{bintree.apex, bintree.left, bintree.right}};
    std::set<std::tuple<int, int, int>> rows, same;
    bintree.forEachRow(33, 33, [&](int row, int west, int east) { rows.emplace(row, west, east); });
    plan.forEachRow(33, 33, [&](int row, int west, int east) { same.emplace(row, west, east); });
    EXPECT_EQ(rows, same);
    EXPECT_EQ(bintree.at(9, 11).u, plan.at(9, 11).u);
    EXPECT_EQ(bintree.at(9, 11).w, plan.at(9, 11).w);
}

} // namespace
