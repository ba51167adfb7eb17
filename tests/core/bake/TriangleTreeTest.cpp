// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/TriangleTree.h>

#include "MadeMeshes.h"
#include "Random.h"

namespace
{

using namespace osgPMObjects::core;

/// 200 random triangles in a cube of side 2.
struct Soup
{
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    testsupport::Random random{7};

    Soup()
    {
        for (int i = 0; i < 300; ++i)
            positions.push_back(anywhere());
        for (int i = 0; i < 200; ++i)
        {
            const std::uint32_t a = random.below(300), b = (a + 1 + random.below(299)) % 300;
            triangles.push_back({a, b, random.below(300)});
        }
    }

    glm::dvec3 anywhere()
    {
        const double x = random.unit(), y = random.unit();
        return 2.0 * glm::dvec3(x, y, random.unit()) - 1.0;
    }

    const glm::dvec3& at(std::uint32_t t, std::size_t corner) const
    {
        return positions[triangles[t][corner]];
    }
};

TEST(TriangleTree, FindsTheNearestTriangleThatCounts)
{
    Soup soup;
    const TriangleTree tree(soup.positions, soup.triangles);
    const auto isEven = [](std::uint32_t t) { return t % 2 == 0; };
    for (int i = 0; i < 200; ++i)
    {
        const glm::dvec3 p = 1.5 * soup.anywhere();
        double best = 1e300;
        for (std::uint32_t t = 0; t < soup.triangles.size(); t += 2)
            best =
                std::min(best, glm::length(p - nearestPoint(p, soup.at(t, 0), soup.at(t, 1), soup.at(t, 2))));
        const TrianglePoint found = tree.nearest(p, 1e300, isEven);
        ASSERT_NE(found.triangle, TrianglePoint::kNone);
        EXPECT_EQ(found.triangle % 2, 0u);
        EXPECT_NEAR(found.distance, best, 1e-12);
        EXPECT_NEAR(glm::length(found.point - p), best, 1e-12);
        EXPECT_EQ(tree.nearest(p, 0.99 * best, isEven).triangle, TrianglePoint::kNone);
        EXPECT_DOUBLE_EQ(tree.nearest(p, 1e300).distance, tree.distance(p));
    }
}

TEST(TriangleTree, FindsTheFirstTriangleAlongARay)
{
    Soup soup;
    const TriangleTree tree(soup.positions, soup.triangles);
    int hits = 0;
    for (int i = 0; i < 200; ++i)
    {
        const glm::dvec3 from = soup.anywhere(), direction = glm::normalize(soup.anywhere());
        double first = 1e300;
        for (std::uint32_t t = 1; t < soup.triangles.size(); t += 2)
            if (const double d = rayDistance(from, direction, soup.at(t, 0), soup.at(t, 1), soup.at(t, 2));
                d >= 0.0)
                first = std::min(first, d);
        const TrianglePoint found =
            tree.firstHit(from, direction, 1e300, [](std::uint32_t t) { return t % 2 == 1; });
        EXPECT_EQ(found.triangle != TrianglePoint::kNone, first < 1e300);
        if (found.triangle == TrianglePoint::kNone) continue;
        ++hits;
        EXPECT_DOUBLE_EQ(found.distance, first);
        EXPECT_LT(glm::length(found.point - from - first * direction), 1e-12);
        EXPECT_TRUE(tree.isHit(from, direction, 0.99 * first));
        EXPECT_EQ(
            tree.firstHit(from, direction, 0.99 * first, [](std::uint32_t t) { return t % 2 == 1; }).triangle,
            TrianglePoint::kNone);
    }
    EXPECT_GT(hits, 50);
}

TEST(TriangleTree, OfNothingFindsNothing)
{
    const TriangleTree tree({}, {});
    EXPECT_EQ(tree.nearest({}, 1e300).triangle, TrianglePoint::kNone);
    EXPECT_EQ(tree.firstHit({}, {1.0, 0.0, 0.0}, 1e300).triangle, TrianglePoint::kNone);
}

} // namespace
