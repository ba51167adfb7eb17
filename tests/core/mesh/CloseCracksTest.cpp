// SPDX-License-Identifier: Apache-2.0
// Cracks are closed in the neighbourhood of changes as in the whole mesh.
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/CloseCracks.h>
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>

#include "BrokenMeshes.h"
#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace brokenmeshes;
using testsupport::meshOf;

struct Closed
{
    Mesh mesh;
    CrackPasses passes;
    ClosedCracks report;
};

Closed closed(Mesh mesh, double tolerance, double wholeShare)
{
    Closed c{std::move(mesh), {}, {}};
    weldPositions(c.mesh, 1e-6);
    c.passes = {.tVertices = {.tolerance = tolerance},
                .degenerateHeight = 1e-7,
                .most = 20,
                .wholeShare = wholeShare};
    c.report = closeCracks(c.mesh, c.passes);
    compactMesh(c.mesh);
    return c;
}

TEST(CloseCracks, NeighbourhoodsDoWhatTheWholeDoes)
{
    int manyPasses = 0;
    for (unsigned seed = 1; seed <= 12; ++seed)
    {
        const double tolerance = seed % 2 == 0 ? 0.02 : 1e-4; // stray corners need many passes
        const Mesh mesh = brokenSoup(seed, 60, 8, 0.4 * tolerance);
        const Closed whole = closed(mesh, tolerance, 0.0), near = closed(mesh, tolerance, 2.0);
        ASSERT_EQ(near.mesh.faces, whole.mesh.faces) << seed;
        ASSERT_EQ(near.mesh.positions, whole.mesh.positions) << seed;
        ASSERT_EQ(near.mesh.wedgePositions, whole.mesh.wedgePositions) << seed;
        EXPECT_EQ(near.passes.made, whole.passes.made) << seed;
        EXPECT_EQ(near.report.tVertices.inserted, whole.report.tVertices.inserted) << seed;
        EXPECT_EQ(near.report.duplicates.kept, whole.report.duplicates.kept) << seed;
        manyPasses += whole.passes.made > 5;
    }
    EXPECT_GE(manyPasses, 5) << "otherwise there was little to see";
}

/// Mutation: a pass that is told of no change does not find the defects.
TEST(CloseCracks, WhatIsNotSaidToHaveChangedIsNotLookedAt)
{
    Mesh mesh =
        meshOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}, {0, -2, 0}, {2, -2, 0}}, {{0, 1, 2}, {3, 4, 5}});
    CrackPasses passes{.tVertices = {.tolerance = 1e-4}, .most = 20, .isWhole = false, .wholeShare = 2.0};
    EXPECT_EQ(closeCracks(mesh, passes).tVertices.inserted, 0u);
    passes.changed = {3};
    EXPECT_EQ(closeCracks(mesh, passes).tVertices.inserted, 1u);
    EXPECT_EQ(mesh.faces.size(), 3u);
}

} // namespace
