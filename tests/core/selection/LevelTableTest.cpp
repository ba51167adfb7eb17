// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/LevelTable.h>

#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;

TEST(LevelTable, ThatGrowsOrGetsBetterIsNone)
{
    const LevelTable table = testsupport::levelTable(100);
    const auto isOneWith = [&](auto change)
    {
        LevelTable changed = table;
        change(changed);
        return isLevelTable(changed);
    };
    EXPECT_TRUE(isOneWith([](LevelTable&) {}));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t.faces[5] = t.faces[4] + 1; }));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t.errors[5].distance = 0.0f; }));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t.errors[5].colour = 0.0f; }));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t.errors[0].normal = 1e-6f; }));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t.errors.pop_back(); }));
    EXPECT_FALSE(isOneWith([](LevelTable& t) { t = {}; }));
    EXPECT_TRUE(isOneWith(
        [](LevelTable& t) {
            t.measured = ErrorLadder(std::vector<MeasuredLevel>{{0, {}}, {96, {1.0f, 1.0f}}});
        }));
    EXPECT_FALSE(isOneWith(
        [](LevelTable& t) {
            t.measured = ErrorLadder(std::vector<MeasuredLevel>{{0, {}}, {97, {1.0f, 1.0f}}});
        }));
    EXPECT_FALSE(isOneWith(
        [](LevelTable& t) {
            t.measured = ErrorLadder(std::vector<MeasuredLevel>{{1, {}}});
        }));
}

TEST(LevelTable, KnowsTheCoarsestLevelWithSoManyFaces)
{
    LevelTable table;
    table.faces = {40, 40, 24, 24, 10};
    table.errors.resize(5);
    EXPECT_EQ(table.coarsestWith(0), 4u);
    EXPECT_EQ(table.coarsestWith(10), 4u);
    EXPECT_EQ(table.coarsestWith(11), 3u);
    EXPECT_EQ(table.coarsestWith(24), 3u);
    EXPECT_EQ(table.coarsestWith(40), 1u);
    EXPECT_EQ(table.coarsestWith(41), 0u) << "a mesh that has fewer is drawn whole";
}

} // namespace
