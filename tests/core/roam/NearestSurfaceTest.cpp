// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/NearestSurface.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM;

/// Distance to dense points of every triangle: never less than the true one, by at most the points' spacing
/// more.
double sampledDistance(const core::RoamMesh& mesh, const glm::dvec3& point)
{
    double least = 1e30;
    constexpr int kSteps = 12;
    const core::DrawnMesh drawn = mesh.drawn();
    for (const core::LeafTriangle& t : drawn.triangles)
    {
        glm::dvec3 p[3];
        for (int c = 0; c < 3; ++c)
            p[c] = drawn.position(t.vertices[c]);
        for (int a = 0; a <= kSteps; ++a)
            for (int b = 0; a + b <= kSteps; ++b)
            {
                const double u = static_cast<double>(a) / kSteps, v = static_cast<double>(b) / kSteps;
                least = std::min(least, glm::distance(point, p[0] * (1 - u - v) + p[1] * u + p[2] * v));
            }
    }
    return least;
}

} // namespace

class NearestSurfaces : public testing::TestWithParam<int>
{
};

TEST_P(NearestSurfaces, AgreesWithBruteForce)
{
    core::RoamMesh mesh(core::SplitBounds(testsupport::planarTile(testsupport::hills(65, 65)), GetParam()));
    mesh.refine(4.0);
    testsupport::Random random(21);
    for (int i = 0; i < 40; ++i)
    {
        const glm::dvec3 point(random.unit() * 1900, random.unit() * 1900, 100 + 1200 * random.unit());
        const double exact = core::nearestSurfaceM(mesh.tree(), point);
        const double sampled = sampledDistance(mesh, point);
        EXPECT_LE(exact, sampled + 1e-6);
        EXPECT_GE(exact, sampled - 25.0);
    }
}

INSTANTIATE_TEST_SUITE_P(Patches, NearestSurfaces, testing::Values(0, 4));

TEST(NearestSurface, IsTheHeightOverAPlain)
{
    core::HeightField field;
    field.columns = field.rows = 33;
    field.spacingEastM = field.spacingNorthM = 10.0;
    field.heightsM.assign(33 * 33, 7.0f);
    core::RoamMesh mesh(testsupport::planarTile(field));
    mesh.refine(0.0);
    EXPECT_NEAR(core::nearestSurfaceM(mesh.tree(), {101, 207, 8.5}), 1.5, 1e-9);
    EXPECT_NEAR(core::nearestSurfaceM(mesh.tree(), {-30, 207, 47.0}), 50.0, 1e-9);
}
