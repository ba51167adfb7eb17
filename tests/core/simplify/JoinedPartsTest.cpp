// SPDX-License-Identifier: Apache-2.0
// Near parts may join.
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
