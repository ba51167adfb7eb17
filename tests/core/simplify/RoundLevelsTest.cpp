// SPDX-License-Identifier: Apache-2.0
// A cylinder keeps its rotational symmetry.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <gtest/gtest.h>
#include <symmetry/RotationOrbits.h>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A cylinder around the z axis with caps that are fans, one band of quads high; turned by some part of a
/// side, and with shuffled numbers.
Mesh cylinder(std::uint32_t sides, double height = 3.0, double turn = 0.3)
{
    std::vector<glm::dvec3> positions(2 * sides + 2);
    std::vector<std::array<std::uint32_t, 3>> faces;
    std::uint32_t stride = 7; // has no factor in common with the numbers of sides that are asked for
    const auto rim = [&](std::uint32_t side, std::uint32_t end)
    { return side % sides * stride % sides + end * sides; };
    for (std::uint32_t side = 0; side < sides; ++side)
        for (std::uint32_t end = 0; end < 2; ++end)
        {
            const double angle = 2.0 * std::numbers::pi * (side + turn) / sides;
            positions[rim(side, end)] = {std::cos(angle), std::sin(angle), end * height};
        }
    positions[2 * sides] = {0.0, 0.0, 0.0};
    positions[2 * sides + 1] = {0.0, 0.0, height};
    for (std::uint32_t side = 0; side < sides; ++side)
    {
        const std::uint32_t a = rim(side, 0), b = rim(side + 1, 0), c = rim(side, 1), d = rim(side + 1, 1);
        faces.push_back({a, b, d});
        faces.push_back({a, d, c});
        faces.push_back({2 * sides, b, a});
        faces.push_back({2 * sides + 1, c, d});
    }
    return testsupport::meshOf(std::move(positions), faces);
}

/// By rim: the least and the largest angle between neighbours, degrees, and their number.
struct Rim
{
    std::size_t count = 0;
    double least = 360.0, most = 0.0;
};

std::array<Rim, 2> rimsOf(const Mesh& level, double height)
{
    std::array<std::vector<double>, 2> angles;
    std::vector<bool> isSeen(level.positions.size(), false);
    for (const Face& face : level.faces)
        for (int corner = 0; corner < 3; ++corner)
        {
            const std::uint32_t p = level.positionOf(face, corner);
            const glm::dvec3& at = level.positions[p];
            if (isSeen[p] || std::hypot(at.x, at.y) < 0.1) continue;
            isSeen[p] = true;
            angles[at.z > 0.5 * height].push_back(std::atan2(at.y, at.x) * 180.0 / std::numbers::pi);
        }
    std::array<Rim, 2> rims;
    for (int end = 0; end < 2; ++end)
    {
        std::sort(angles[end].begin(), angles[end].end());
        rims[end].count = angles[end].size();
        for (std::size_t i = 0; i < angles[end].size(); ++i)
        {
            const bool isLast = i + 1 == angles[end].size();
            const double gap = (isLast ? angles[end][0] + 360.0 : angles[end][i + 1]) - angles[end][i];
            rims[end].least = std::min(rims[end].least, gap);
            rims[end].most = std::max(rims[end].most, gap);
        }
    }
    return rims;
}

/// Returns the largest difference of two angles of a rim among the levels with so many sides at both ends, in
/// degrees; 360 without any.
double unevennessAt(std::size_t sides, const Mesh& mesh, const SimplifySettings& settings)
{
    const CollapseSequence sequence = simplify(mesh, settings);
    EXPECT_TRUE(isSequenceOf(sequence, mesh));
    double least = 360.0;
    for (std::size_t steps = 0; steps <= sequence.steps.size(); ++steps)
    {
        const auto rims = rimsOf(meshAfter(mesh, sequence, steps), 3.0);
        if (rims[0].count == sides && rims[1].count == sides)
            least = std::min(least, std::max(rims[0].most - rims[0].least, rims[1].most - rims[1].least));
    }
    return least;
}

TEST(RoundLevels, HaveEqualSidesAllAroundAtHalvesOfThem)
{
    for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
        for (const bool seams : {true, false})
        {
            const SimplifySettings settings{.placement = placement, .keepSeams = seams};
            for (const std::size_t sides : {16u, 8u, 4u})
                EXPECT_LT(unevennessAt(sides, cylinder(32), settings), 1e-4)
                    << sides << " sides, placement " << int(placement);
            EXPECT_LT(unevennessAt(6, cylinder(12), settings), 1e-4) << int(placement);
        }
}

/// The mutation: nobody keeps the symmetry.
TEST(RoundLevels, AreUnevenWhereNobodyKeepsThemRound)
{
    for (const Placement placement : {Placement::subset, Placement::optimal})
        EXPECT_GT(unevennessAt(16, cylinder(32), {.placement = placement, .keepSymmetry = false}), 5.0);
}

TEST(RotationOrbits, FindTheFoldOfACylinder)
{
    const Mesh mesh = cylinder(24, 3.0, 0.1);
    const RotationOrbits orbits = rotationOrbits(mesh.positions, positionTriangles(mesh));
    ASSERT_EQ(orbits.fold, 24u);
    EXPECT_EQ(orbits.axis, 2);
    for (std::uint32_t p = 0; p < mesh.positions.size(); ++p)
    {
        EXPECT_LT(glm::distance(orbits.imageOf(mesh.positions[p], 5), mesh.positions[orbits.imageOf(p, 5)]),
                  1e-5);
        EXPECT_EQ(orbits.imageOf(p, 24), p);
    }
    EXPECT_NEAR(glm::length(orbits.within({3.0, 4.0, 1.0}, 1.0) - glm::dvec3(0.6, 0.8, 1.0)), 0.0, 1e-9);
    EXPECT_EQ(orbits.stepFor(0, orbits.next[0]), 2u);
    EXPECT_EQ(orbits.stepFor(0, orbits.imageOf(0u, 2)), 3u);
    EXPECT_EQ(orbits.stepFor(0, 2 * 24), 1u); // the middle of a cap
}

TEST(RotationOrbits, AreNoneWhereAVertexOrAFaceIsNotTurned)
{
    Mesh bent = cylinder(24);
    bent.positions[3].x += 1e-3;
    EXPECT_FALSE(rotationOrbits(bent.positions, positionTriangles(bent)).isRound());
    Mesh open = cylinder(24);
    open.faces.pop_back();
    EXPECT_FALSE(rotationOrbits(open.positions, positionTriangles(open)).isRound());
    const Mesh cube = testsupport::cube();
    EXPECT_FALSE(rotationOrbits(cube.positions, positionTriangles(cube)).isRound());
}

} // namespace
