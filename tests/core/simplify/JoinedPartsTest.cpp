// SPDX-License-Identifier: Apache-2.0
// Near parts may join.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// A row of cubes, a tenth of their size apart.
Mesh street(int houses)
{
    Mesh mesh = testsupport::cube();
    for (int i = 1; i < houses; ++i)
        mesh = testsupport::together(mesh, testsupport::cube(), {1.1 * i, 0.0, 0.0});
    return mesh;
}

double meanError(const Mesh& mesh, double joinDistance, Placement placement)
{
    const CollapseSequence sequence =
        simplify(mesh, {.placement = placement, .keepSeams = false, .joinDistance = joinDistance});
    EXPECT_TRUE(isSequenceOf(sequence, mesh));
    EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
    const Mesh level = meshAfter(mesh, sequence, stepsToFaces(sequence, mesh.faces.size() / 10));
    EXPECT_TRUE(isValid(level));
    return surfaceChange(mesh, level, 20000).mean;
}

TEST(JoinedParts, LoseLessThanPartsThatVanish)
{
    const Mesh mesh = street(20);
    for (const Placement placement : {Placement::subset, Placement::optimal})
        EXPECT_LT(meanError(mesh, 0.2, placement), 0.9 * meanError(mesh, 0.0, placement));
}

/// A row of cubes that are one part: a triangle leads from the bottom of each to the next.
Mesh fins(int count)
{
    Mesh mesh = street(count);
    const auto corner = [&](int cube, double x)
    {
        std::uint32_t nearest = 0;
        for (std::uint32_t p = 0; p < mesh.positions.size(); ++p)
            if (glm::distance(mesh.positions[p], mesh.positions[0] + glm::dvec3(1.1 * cube + x, 0.0, 0.0)) <
                1e-9)
                nearest = p;
        return nearest;
    };
    for (int cube = 0; cube + 1 < count; ++cube)
    {
        Face face{{}, 0, 0};
        const std::uint32_t corners[] = {corner(cube, 0.0), corner(cube, 1.0), corner(cube + 1, 0.0)};
        for (int c = 0; c < 3; ++c)
            for (std::uint32_t wedge = 0; wedge < mesh.wedgeCount(); ++wedge)
                if (mesh.wedgePositions[wedge] == corners[c]) face.wedges[c] = wedge;
        mesh.faces.push_back(face);
    }
    return mesh;
}

/// How many steps lead over a gap between two cubes.
std::ptrdiff_t stepsOverGaps(const Mesh& mesh, const SimplifySettings& settings)
{
    const CollapseSequence sequence = simplify(mesh, settings);
    EXPECT_TRUE(isSequenceOf(sequence, mesh));
    EXPECT_EQ(sequence.steps.back().facesAfter, 0u);
    EXPECT_TRUE(isValid(meshAfter(mesh, sequence, stepsToFaces(sequence, mesh.faces.size() / 10))));
    const auto isOverGap = [&](const CollapseStep& step)
    { return std::abs(glm::distance(mesh.positions[step.from], mesh.positions[step.to]) - 0.1) < 1e-6; };
    return std::count_if(sequence.steps.begin(), sequence.steps.end(), isOverGap);
}

TEST(JoinedParts, FinsOfOnePartJoinOnlyWhereTheyMay)
{
    const Mesh mesh = fins(20);
    SimplifySettings settings{.keepSeams = false, .joinDistance = 0.2};
    const std::ptrdiff_t alongEdges = stepsOverGaps(mesh, settings);
    settings.joinWithinParts = true;
    EXPECT_GT(stepsOverGaps(mesh, settings), alongEdges + 10);
    settings.joinDistance = 0.05;
    EXPECT_EQ(stepsOverGaps(mesh, settings), alongEdges);
}

TEST(JoinedParts, AreNoFartherApartThanAllowed)
{
    const Mesh mesh = street(20);
    EXPECT_EQ(meanError(mesh, 0.05, Placement::subset), meanError(mesh, 0.0, Placement::subset));
}

TEST(JoinedParts, MakeSoundSequencesOfManyKinds)
{
    testsupport::Random random(1);
    for (const double distance : {0.05, 0.3, 2.0})
        for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
        {
            Mesh mesh = testsupport::together(testsupport::waves(15, 15), street(5), {2.0, 2.0, 1.0});
            mesh = testsupport::together(mesh, testsupport::meshOf(testsupport::soup(random, 200, 500)),
                                         {5.0, 5.0, 0.0});
            const CollapseSequence sequence =
                simplify(mesh, {.placement = placement, .joinDistance = distance});
            EXPECT_TRUE(isSequenceOf(sequence, mesh));
        }
}

} // namespace
