// SPDX-License-Identifier: Apache-2.0
// What stands in a scene is found by its place.
#include "simulation/contact/ObstacleMap.h"

#include <algorithm>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace
{

using namespace simulation;

Obstacle treeAt(double x, double y, double radiusM = 0.3)
{
    Obstacle tree;
    tree.kind = ObstacleKind::tree;
    tree.isRound = true;
    tree.middle = {x, y};
    tree.halfM = glm::dvec2(radiusM);
    tree.highM = 10.0;
    return tree;
}

TEST(ObstacleMap, FindsWhatTouchesARectangleAndNothingElse)
{
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> place(-500.0, 500.0), half(0.1, 40.0), turn(0.0, 6.3);
    ObstacleList list;
    for (int i = 0; i < 3000; ++i)
    {
        Obstacle thing = treeAt(place(random), place(random));
        thing.isRound = i % 2 == 0;
        const double heading = turn(random);
        thing.along = {std::cos(heading), std::sin(heading)};
        thing.halfM = {half(random), half(random)};
        list.add(thing);
    }
    const ObstacleMap map(list);
    std::vector<std::uint32_t> found;
    for (int i = 0; i < 500; ++i)
    {
        const glm::dvec2 low(place(random), place(random)), high = low + glm::dvec2(half(random));
        map.near(low, high, found);
        std::vector<std::uint32_t> expected;
        for (std::uint32_t n = 0; n < map.size(); ++n)
        {
            const glm::dvec2 reach = map.at(n).reachM(), middle = map.at(n).middle;
            if (middle.x + reach.x >= low.x && middle.x - reach.x <= high.x && middle.y + reach.y >= low.y &&
                middle.y - reach.y <= high.y)
                expected.push_back(n);
        }
        ASSERT_EQ(found, expected);
    }
}

TEST(ObstacleMap, HoldsAsManyThingsAsAWorldHas)
{
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> place(-13'000.0, 13'000.0);
    ObstacleList list;
    for (int i = 0; i < 400'000; ++i)
        list.add(treeAt(place(random), place(random)), i % 2 == 0 ? "oak" : "spruce");
    const ObstacleMap map(std::move(list));
    EXPECT_EQ(map.size(), 400'000U);
    std::vector<std::uint32_t> found;
    std::size_t all = 0;
    for (int i = 0; i < 10'000; ++i)
    {
        const glm::dvec2 at(place(random), place(random));
        map.near(at - 4.0, at + 4.0, found);
        all += found.size();
    }
    // 592 things in a square kilometre: 0.042 in such a rectangle, with what reaches into it.
    EXPECT_NEAR(static_cast<double>(all) / 10'000.0, 0.0438, 0.01);
    EXPECT_EQ(map.nameOf(1), "spruce");
}

TEST(ObstacleMap, LeavesOutWhatIsNoBody)
{
    ObstacleList list;
    list.add(treeAt(0.0, 0.0, 0.0));
    list.add(treeAt(std::numeric_limits<double>::quiet_NaN(), 0.0));
    Obstacle flat = treeAt(0.0, 0.0);
    flat.highM = flat.lowM;
    list.add(flat);
    EXPECT_TRUE(list.obstacles().empty());
    list.add(treeAt(1e300, 0.0)); // far away, but a body
    std::vector<std::uint32_t> found;
    ObstacleMap(list).near({-1.0, -1.0}, {1.0, 1.0}, found);
    EXPECT_TRUE(found.empty());
    ObstacleMap().near({-1.0, -1.0}, {1.0, 1.0}, found);
    EXPECT_TRUE(found.empty());
}

TEST(ObstacleMap, NamesAThingByItsKindWhereItHasNoName)
{
    ObstacleList list, more;
    list.add(treeAt(0.0, 0.0));
    more.add(treeAt(5.0, 0.0), "oak");
    list.add(more);
    const ObstacleMap map(list);
    EXPECT_EQ(map.nameOf(0), "tree");
    EXPECT_EQ(map.nameOf(1), "oak");
}

} // namespace
