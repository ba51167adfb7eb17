// SPDX-License-Identifier: Apache-2.0
// Removals whose holes are filled by fans are played as collapses.
#include <algorithm>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include <osgPMObjects/core/progressive/LevelMesh.h>
#include <osgPMObjects/core/simplify/CollapsesOfRemovals.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "ClosedMeshes.h"
#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

const RemovalOptions kByFans{.triangulation = HoleTriangulation::fan};

/// The corners of faces as attributes say them, so that meshes with other numbers compare; each begins at its
/// least corner.
using Corners = std::multiset<std::array<std::tuple<double, double, double, float, std::uint32_t>, 3>>;

Corners cornersOf(const Mesh& mesh)
{
    Corners all;
    for (const Face& face : mesh.faces)
    {
        std::array<std::tuple<double, double, double, float, std::uint32_t>, 3> corners;
        for (int c = 0; c < 3; ++c)
        {
            const glm::dvec3& p = mesh.at(face, c);
            const float u = mesh.texCoords[0].empty() ? 0.0f : mesh.texCoords[0][face.wedges[c]].x;
            corners[c] = {p.x, p.y, p.z, u, face.material};
        }
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        all.insert(corners);
    }
    return all;
}

std::vector<Mesh> subjects()
{
    Mesh painted = ball(9, 16);
    paint(painted, [](const glm::dvec3& centre) { return centre.z > 0.0; });
    return {ball(9, 16), torus(18, 10), painted, griddedCube(5), waves(14, 12), texturedInHalves(12, 9)};
}

TEST(CollapsesOfRemovals, HaveTheFacesOfTheRemovalsAtEveryLevel)
{
    for (const Mesh& mesh : subjects())
    {
        const RemovalSequence removals = removeVertices(mesh, kByFans);
        ASSERT_EQ(removalDefectOf(removals, mesh), "");
        const CollapseSequence collapses = collapsesOf(mesh, removals);
        ASSERT_TRUE(isSequenceOf(collapses, mesh));
        ASSERT_EQ(collapses.steps.size(), removals.steps.size());
        ASSERT_GT(2 * removals.steps.size(), removals.positionCount);
        for (std::size_t steps = 0; steps <= removals.steps.size(); steps += 3)
            ASSERT_EQ(cornersOf(meshAfter(mesh, collapses, steps)),
                      cornersOf(meshAfter(mesh, removals, steps).mesh))
                << steps;
    }
}

TEST(CollapsesOfRemovals, ArePlayedByAProgressiveMesh)
{
    const Mesh mesh = texturedInHalves(12, 9);
    const RemovalSequence removals = removeVertices(mesh, kByFans);
    const ProgressiveMesh progressive = buildProgressiveMesh(mesh, collapsesOf(mesh, removals));
    ASSERT_TRUE(isValid(progressive));
    ASSERT_EQ(progressive.stepCount, removals.steps.size());
    for (std::uint32_t steps = 0; steps <= progressive.stepCount; steps += 5)
        ASSERT_EQ(cornersOf(meshAfter(progressive, steps)), cornersOf(meshAfter(mesh, removals, steps).mesh))
            << steps;
}

TEST(CollapsesOfRemovals, FillHolesNearlyAsDelaunayDoes)
{
    const Mesh mesh = ball(20, 32);
    const RemovalSequence fans = removeVertices(mesh, kByFans), delaunay = removeVertices(mesh);
    const std::size_t steps = delaunay.stepsToFaces(mesh.faces.size() / 4);
    EXPECT_LT(fans.steps[steps - 1].error, 1.5 * delaunay.steps[steps - 1].error);
    EXPECT_EQ(fans.steps.size(), delaunay.steps.size());
}

TEST(CollapsesOfRemovals, PartsShrinkAndAreGoneAsAWhole)
{
    const Mesh mesh = together(ball(12, 20),
                               meshOf({{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, 0.01}},
                                      {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}),
                               {3.0, 0.0, 0.0});
    Mesh one = mesh;
    for (Face& face : one.faces)
        face.material = 0;
    const RemovalSequence removals = removeVertices(one, kByFans);
    ASSERT_TRUE(std::any_of(removals.steps.begin(), removals.steps.end(),
                            [](const RemovalStep& step) { return step.isOfPart; }));
    const CollapseSequence collapses = collapsesOf(one, removals);
    EXPECT_TRUE(isSequenceOf(collapses, one));
    EXPECT_LT(collapses.steps.size(), removals.steps.size()) << "the last positions of a part have no faces";
    EXPECT_EQ(collapses.steps.back().facesAfter, removals.facesAfter(removals.steps.size()));
}

} // namespace
