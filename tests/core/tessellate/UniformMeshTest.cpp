// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <osgPMObjects/core/tessellate/UniformMesh.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

double areaOf(const std::vector<glm::dvec3>& p, const Triangle& t)
{
    return 0.5 * glm::length(glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]));
}

/// Positions that lie on the segment from a to b, as plain numbers.
std::set<std::array<double, 3>> alongEdge(const UniformMesh& mesh, const glm::dvec3& a, const glm::dvec3& b)
{
    std::set<std::array<double, 3>> on;
    for (const glm::dvec3& p : mesh.positions)
        if (glm::length(glm::cross(p - a, b - a)) < 1e-12 && glm::dot(p - a, p - b) <= 1e-12)
            on.insert({p.x, p.y, p.z});
    return on;
}

TEST(UniformMesh, LeavesATriangleAloneThatIsSmallEnough)
{
    const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto mesh = meshUniformly(positions, std::vector<Triangle>{{0, 1, 2}}, std::sqrt(2.0));
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->triangles.size(), 1u);
    EXPECT_TRUE(mesh->midpointOf.empty());
}

TEST(UniformMesh, QuartersAnEquilateralTriangle)
{
    const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
    const auto mesh = meshUniformly(positions, std::vector<Triangle>{{0, 1, 2}}, 0.5 + 1e-9);
    ASSERT_TRUE(mesh);
    EXPECT_EQ(mesh->triangles.size(), 4u);
    EXPECT_EQ(mesh->positions.size(), 6u);
}

TEST(UniformMesh, KeepsAreaConformityAndLengthOfRandomMeshes)
{
    Random random(31);
    for (int i = 0; i < 500; ++i)
    { // a fan around an apex: closed rings of shared edges
        std::vector<glm::dvec3> positions{{0, 0, random.unit()}};
        std::vector<Triangle> fan;
        const std::uint32_t n = 3 + random.below(6);
        for (std::uint32_t k = 0; k < n; ++k)
        {
            const double angle = 6.28 * (k + 0.5 * random.unit()) / n;
            positions.emplace_back(std::cos(angle) * 5, std::sin(angle), random.unit());
            fan.push_back({0, 1 + k, 1 + (k + 1) % n});
        }
        const double longest = 0.2 + random.unit();
        const auto mesh = meshUniformly(positions, fan, longest);
        ASSERT_TRUE(mesh);
        ASSERT_EQ(mesh->positions.size(), positions.size() + mesh->midpointOf.size());
        std::vector<double> areas(fan.size());
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        for (std::size_t t = 0; t < mesh->triangles.size(); ++t)
        {
            const Triangle& corners = mesh->triangles[t];
            areas[mesh->origin[t]] += areaOf(mesh->positions, corners);
            for (int e = 0; e < 3; ++e)
            {
                const std::uint32_t a = corners[e], b = corners[(e + 1) % 3];
                EXPECT_LE(glm::distance(mesh->positions[a], mesh->positions[b]), longest);
                EXPECT_EQ((++edges[{a, b}]), 1);
            }
        }
        for (std::size_t t = 0; t < fan.size(); ++t)
            EXPECT_NEAR(areas[t], areaOf(positions, fan[t]), 1e-12);
        for (const auto& [edge, count] : edges) // an edge without a partner lies on the rim: no T-junctions
            if (!edges.contains({edge.second, edge.first}))
            {
                const glm::dvec3 middle = 0.5 * (mesh->positions[edge.first] + mesh->positions[edge.second]);
                bool isOnRim = false;
                for (const Triangle& t : fan)
                {
                    const glm::dvec3 &a = positions[t[1]], &b = positions[t[2]];
                    isOnRim = isOnRim || glm::length(glm::cross(middle - a, b - a)) < 1e-12;
                }
                EXPECT_TRUE(isOnRim);
            }
    }
}

TEST(UniformMesh, DividesASharedEdgeAlikeInEitherDirectionAndInAnotherCall)
{
    Random random(32);
    for (int i = 0; i < 200; ++i)
    {
        const auto position = [&] { return glm::dvec3(random.unit(), random.unit(), random.unit()); };
        const glm::dvec3 a = position(), b = position();
        const auto one = meshUniformly(std::vector{a, b, position()}, std::vector<Triangle>{{0, 1, 2}}, 0.1);
        const auto other =
            meshUniformly(std::vector{position(), b, a}, std::vector<Triangle>{{1, 2, 0}}, 0.1);
        ASSERT_TRUE(one);
        ASSERT_TRUE(other);
        EXPECT_EQ(alongEdge(*one, a, b), alongEdge(*other, a, b)); // to the last bit
        const auto finer =
            meshUniformly(std::vector{a, b, position()}, std::vector<Triangle>{{0, 1, 2}}, 0.03);
        ASSERT_TRUE(finer);
        const bool isAlike = alongEdge(*one, a, b) == alongEdge(*finer, a, b);
        EXPECT_EQ(isAlike,
                  glm::distance(a, b) <= 0.03); // the mutation: another edge length divides it otherwise
    }
}

TEST(UniformMesh, RefusesWhatWouldNotEnd)
{
    const std::vector<glm::dvec3> positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Triangle> one{{0, 1, 2}};
    EXPECT_FALSE(meshUniformly(positions, one, 0.0));
    EXPECT_FALSE(meshUniformly(positions, one, -1.0));
    EXPECT_FALSE(meshUniformly(positions, one, std::nan("")));
    const auto refused = meshUniformly(positions, one, 1e-6, 10000);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message(), testing::HasSubstr("more than 10000"));
}

} // namespace
