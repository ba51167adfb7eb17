// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

/// Returns the largest distance, both ways, over ten levels of a sequence.
double largestDistance(const Mesh& mesh, const CollapseSequence& sequence)
{
    double largest = 0.0;
    for (std::size_t level = 1; level <= 10; ++level)
        largest = std::max(
            largest,
            surfaceChange(mesh, meshAfter(mesh, sequence, sequence.steps.size() * level / 10), 5000).largest);
    return largest;
}

TEST(Envelope, HoldsBothSurfacesAtEveryLevel)
{
    Mesh withPlate = testsupport::waves(12, 12);
    withPlate = testsupport::together(withPlate, testsupport::cube(), {3, 3, 0.5});
    testsupport::Random random(1);
    for (const Mesh& mesh : {testsupport::waves(24, 24), testsupport::meshOf(testsupport::sphereMesh(16, 24)),
                             withPlate, testsupport::meshOf(testsupport::soup(random, 60, 100))})
        for (const Placement placement : {Placement::subset, Placement::optimal, Placement::quality})
        {
            const double distance = 0.01 * diagonalOf(mesh);
            const CollapseSequence sequence = simplify(mesh, {.placement = placement, .envelope = distance});
            EXPECT_TRUE(isSequenceOf(sequence, mesh));
            EXPECT_LE(largestDistance(mesh, sequence), distance);
        }
}

TEST(Envelope, LeavesFarFewerFacesThanTheOriginal)
{
    const Mesh mesh = testsupport::waves(24, 24);
    const CollapseSequence sequence = simplify(mesh, {.envelope = 0.02 * diagonalOf(mesh)});
    ASSERT_FALSE(sequence.steps.empty());
    EXPECT_LT(sequence.steps.back().facesAfter, mesh.faces.size() / 8);
}

TEST(Envelope, IsLeftWhereThereIsNone)
{ // control: as many steps without an envelope
    const Mesh mesh = testsupport::waves(24, 24);
    const double distance = 0.01 * diagonalOf(mesh);
    const std::size_t steps = simplify(mesh, {.envelope = distance}).steps.size();
    CollapseSequence free = simplify(mesh);
    free.steps.resize(steps);
    EXPECT_GT(largestDistance(mesh, free), distance);
}

} // namespace
