// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <set>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/PointTree.h>
#include <osgPMObjects/core/mesh/TJunctions.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;

/// Triangles without neighbours, with corners on a lattice: many corners lie on edges of others.
struct Soup
{
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;

    Soup(std::uint32_t count, std::uint32_t side, std::uint32_t seed)
    {
        testsupport::Random random(seed);
        const auto coordinate = [&] { return static_cast<double>(random.below(side)); };
        for (std::uint32_t t = 0; t < count; ++t)
        {
            for (int corner = 0; corner < 3; ++corner)
                positions.push_back({coordinate(), coordinate(), coordinate()});
            triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
    }
};

/// Every pair of edge and vertex, by definition.
std::set<std::pair<std::uint32_t, std::uint32_t>> pairsOf(const Soup& soup, const EdgeTable& edges,
                                                          double tolerance)
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::uint32_t e = 0; e < edges.size(); ++e)
    {
        const auto [from, to] = endsOf(soup.triangles, edges.sides(e).front());
        const glm::dvec3 a = soup.positions[std::min(from, to)],
                         along = soup.positions[std::max(from, to)] - a;
        for (std::uint32_t v = 0; v < soup.positions.size(); ++v)
        {
            if (v == from || v == to || glm::dot(along, along) == 0.0) continue;
            const double share = glm::dot(soup.positions[v] - a, along) / glm::dot(along, along);
            if (share > 1e-4 && share < 1.0 - 1e-4 &&
                glm::length(soup.positions[v] - a - share * along) <= tolerance)
                pairs.insert({e, v});
        }
    }
    return pairs;
}

TEST(TJunctions, AreThoseOfTheDefinition)
{
    for (std::uint32_t seed = 0; seed < 8; ++seed)
    {
        const Soup soup(150, 5 + 6 * seed, seed);
        const EdgeTable edges(soup.triangles, soup.positions.size());
        for (const double tolerance : {1e-6, 0.3})
        {
            const auto [found, isCutShort] =
                findTJunctions(soup.positions, soup.triangles, edges, tolerance, OpenEdges::boundary);
            EXPECT_FALSE(isCutShort);
            std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
            std::set<std::uint32_t> vertices;
            for (const TJunction& t : found)
            {
                EXPECT_TRUE(pairs.insert({t.edge, t.vertex}).second) << "found twice";
                vertices.insert(t.vertex);
            }
            EXPECT_EQ(pairs, pairsOf(soup, edges, tolerance)) << "seed " << seed;
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                                       [](const TJunction& a, const TJunction& b)
                                       { return a.edge != b.edge ? a.edge < b.edge : a.along < b.along; }));
            EXPECT_EQ(countTVertices(soup.positions, soup.triangles, edges, tolerance, OpenEdges::boundary),
                      vertices.size());
        }
    }
}

/// A tolerance larger than the mesh, as one vertex far away gives it: every vertex is near every edge.
TEST(TJunctions, StayFewWhereTheToleranceSwallowsTheMesh)
{
    const Soup soup(20000, 1000, 1);
    const EdgeTable edges(soup.triangles, soup.positions.size());
    const auto [found, isCutShort] =
        findTJunctions(soup.positions, soup.triangles, edges, 1e9, OpenEdges::boundary);
    EXPECT_TRUE(isCutShort);
    EXPECT_GT(found.size(), 60000u);
    EXPECT_LE(found.size(), 4u * (60000u + 60000u) + 65536u);
    EXPECT_GT(countTVertices(soup.positions, soup.triangles, edges, 1e9, OpenEdges::boundary), 59000u);
}

TEST(PointTree, FindsAndTakesPoints)
{
    const Soup soup(400, 50, 3);
    PointTree tree(soup.positions);
    const Extent wanted{{10, 10, 10}, {30, 30, 30}};
    const auto touches = [&](const Extent& box)
    {
        return glm::all(glm::lessThanEqual(box.low, wanted.high)) &&
               glm::all(glm::lessThanEqual(wanted.low, box.high));
    };
    const auto isInside = [&](std::uint32_t p) {
        return wanted.contains({soup.positions[p], soup.positions[p]});
    };
    const auto countInside = [&]
    {
        std::size_t count = 0;
        std::uint64_t work = ~0ull;
        tree.visit(touches, work, [&](std::uint32_t p) { count += isInside(p); });
        return count;
    };
    std::size_t inside = 0;
    for (std::uint32_t p = 0; p < soup.positions.size(); ++p)
        inside += isInside(p);
    ASSERT_GT(inside, 20u);
    EXPECT_EQ(countInside(), inside);
    std::uint64_t work = ~0ull;
    tree.extract(touches, work, [&](std::uint32_t p) { return isInside(p) && p % 2 == 0; });
    EXPECT_LT(countInside(), inside);
    tree.extract(touches, work, isInside);
    EXPECT_EQ(countInside(), 0u);
}

TEST(PointTree, EndsWithItsWork)
{
    const Soup soup(400, 50, 3);
    const PointTree tree(soup.positions);
    std::uint64_t work = 100;
    std::size_t visited = 0;
    tree.visit([](const Extent&) { return true; }, work, [&](std::uint32_t) { ++visited; });
    EXPECT_EQ(work, 0u);
    EXPECT_GT(visited, 30u);
    EXPECT_LE(visited, 100u);
}

/// Large triangles through one another: a point lies in the boxes of an eighth of them.
TEST(TriangleTree, EndsWithItsWork)
{
    const Soup soup(2000, 1000, 9);
    const TriangleTree tree(soup.positions, soup.triangles);
    const double far = std::numeric_limits<double>::infinity();
    for (std::uint32_t p = 0; p < 50; ++p)
    {
        const glm::dvec3 point = 0.5 * (soup.positions[p] + soup.positions[3 * p + 100]);
        std::uint64_t much = 100000, little = 10;
        const auto whole = tree.distance(point, far, much);
        ASSERT_TRUE(whole);
        EXPECT_EQ(*whole, tree.distance(point));
        EXPECT_LT(much, 100000u - 10u) << "more than ten are looked at";
        EXPECT_FALSE(tree.distance(point, far, little));
        EXPECT_EQ(little, 0u);
    }
}

} // namespace
