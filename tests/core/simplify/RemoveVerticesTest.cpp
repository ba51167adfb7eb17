// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>
#include <osgPMObjects/core/simplify/RemoveVertices.h>

#include "ClosedMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

/// Returns vertices - edges + faces of a level, with the number of vertices according to the steps.
long eulerNumber(const Mesh& level, std::size_t vertices)
{
    const EdgeTable edges(positionTriangles(level), level.positions.size());
    return static_cast<long>(vertices) - static_cast<long>(edges.size()) +
           static_cast<long>(level.faces.size());
}

std::size_t stepsWithin(const RemovalSequence& sequence, double error)
{
    return static_cast<std::size_t>(std::count_if(sequence.steps.begin(), sequence.steps.end(),
                                                  [&](const auto& step) { return step.error <= error; }));
}

std::size_t leftBy(const RemovalSequence& sequence, RemovalRefusal reason)
{
    return sequence.left[static_cast<std::size_t>(reason)];
}

TEST(RemoveVertices, AFlatSheetBecomesTwoTrianglesWithoutError)
{
    const Mesh sheet = grid(8, 6);
    const RemovalSequence sequence = removeVertices(sheet);
    ASSERT_EQ(removalDefectOf(sequence, sheet), "");
    EXPECT_EQ(stepsWithin(sequence, 1e-12), 9u * 7u - 4u);
    const RemovalLevel level = meshAfter(sheet, sequence, 9 * 7 - 4);
    EXPECT_EQ(level.mesh.faces.size(), 2u);
    EXPECT_NEAR(surfaceChange(sheet, level.mesh).largest, 0.0, 1e-9);
}

TEST(RemoveVertices, ACubeOfManySquaresBecomesTwelveTrianglesWithoutError)
{
    const Mesh cube = griddedCube(6);
    const RemovalSequence sequence = removeVertices(cube);
    ASSERT_EQ(removalDefectOf(sequence, cube), "");
    ASSERT_EQ(stepsWithin(sequence, 1e-12), sequence.positionCount - 8);
    const RemovalLevel level = meshAfter(cube, sequence, sequence.positionCount - 8);
    EXPECT_EQ(level.mesh.faces.size(), 12u);
    EXPECT_NEAR(surfaceChange(cube, level.mesh).largest, 0.0, 1e-9);
    const RemovalSequence withoutCreases = removeVertices(cube, {.creaseAngleDeg = 180.0});
    EXPECT_LT(stepsWithin(withoutCreases, 1e-12), sequence.positionCount - 8)
        << "edges of the cube are no planes";
}

TEST(RemoveVertices, AClosedBallKeepsEulersRelationsDownToATetrahedron)
{
    const Mesh mesh = ball(9, 16);
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    ASSERT_EQ(sequence.steps.size(), mesh.positions.size() - 4);
    for (std::size_t k = 0; k <= sequence.steps.size(); ++k)
    {
        const Mesh level = meshAfter(mesh, sequence, k).mesh;
        const std::size_t v = mesh.positions.size() - k, f = level.faces.size();
        const MeshCounts counts = countMesh(level);
        ASSERT_EQ(counts.positions, v) << k;
        ASSERT_EQ(eulerNumber(level, v), 2) << k;
        ASSERT_LE(EdgeTable(positionTriangles(level), level.positions.size()).size(), 3 * v - 6) << k;
        ASSERT_LE(f, 2 * v - 4) << k;
        ASSERT_EQ(counts.boundaryEdges + counts.nonManifoldEdges + counts.duplicates, 0u) << k;
    }
    EXPECT_EQ(leftBy(sequence, RemovalRefusal::joins), 4u);
}

TEST(RemoveVertices, ATorusKeepsItsHole)
{
    const Mesh mesh = torus(18, 10);
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_GT(sequence.steps.size(), mesh.positions.size() - 20);
    for (std::size_t k = 0; k <= sequence.steps.size(); k += 7)
        ASSERT_EQ(eulerNumber(meshAfter(mesh, sequence, k).mesh, mesh.positions.size() - k), 0) << k;
}

TEST(RemoveVertices, MoreThanCanBeRemovedIsClampedAndSaid)
{
    const Mesh mesh = ball(5, 8);
    const RemovalSequence sequence = removeVertices(mesh);
    const RemovalLevel most = meshAfter(mesh, sequence, sequence.steps.size());
    const RemovalLevel more = meshAfter(mesh, sequence, mesh.positions.size());
    EXPECT_FALSE(most.isClamped);
    EXPECT_TRUE(more.isClamped);
    EXPECT_EQ(more.removed, sequence.steps.size());
    EXPECT_EQ(more.mesh.faces, most.mesh.faces);
}

TEST(RemoveVertices, EveryNumberOfFacesIsFound)
{
    const Mesh mesh = ball(7, 12);
    const RemovalSequence sequence = removeVertices(mesh);
    for (std::size_t faces = 0; faces <= mesh.faces.size() + 1; ++faces)
    {
        const std::size_t steps = sequence.stepsToFaces(faces);
        EXPECT_EQ(meshAfter(mesh, sequence, steps).mesh.faces.size(), sequence.facesAfter(steps));
        EXPECT_TRUE(steps == sequence.steps.size() || sequence.facesAfter(steps) <= faces) << faces;
        EXPECT_TRUE(steps == 0 || sequence.facesAfter(steps - 1) > faces) << faces;
    }
}

TEST(RemoveVertices, SupportVerticesStay)
{
    const Mesh mesh = ball(9, 16);
    RemovalOptions options;
    options.isSupport.resize(mesh.positions.size(), false);
    for (std::size_t p = 0; p < mesh.positions.size(); p += 5)
        options.isSupport[p] = true;
    const RemovalSequence sequence = removeVertices(mesh, options);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    for (const RemovalStep& step : sequence.steps)
        EXPECT_FALSE(options.isSupport[step.position]);
    EXPECT_EQ(leftBy(sequence, RemovalRefusal::support), (mesh.positions.size() + 4) / 5);
}

TEST(RemoveVertices, ABorderOfMaterialsIsRemovedAlongIt)
{
    Mesh mesh = ball(15, 24); // ring 7 is the equator
    paint(mesh, [](const glm::dvec3& centre) { return centre.z > 0.0; });
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_LE(sequence.facesAfter(sequence.steps.size()), 20u);
    for (std::size_t k = 0; k <= sequence.steps.size(); k += 5)
    {
        const Mesh level = meshAfter(mesh, sequence, k).mesh;
        const auto triangles = positionTriangles(level);
        const EdgeTable edges(triangles, level.positions.size());
        for (std::uint32_t e = 0; e < edges.size(); ++e)
        {
            const auto sides = edges.sides(e);
            if (level.faces[faceOf(sides[0])].material == level.faces[faceOf(sides[1])].material) continue;
            const auto [from, to] = endsOf(triangles, sides[0]);
            ASSERT_NEAR(level.positions[from].z, 0.0, 1e-12) << "at level " << k;
            ASSERT_NEAR(level.positions[to].z, 0.0, 1e-12) << "at level " << k;
        }
    }
}

TEST(RemoveVertices, WhereBordersMeetThePositionStays)
{
    Mesh mesh = grid(6, 6);
    paint(mesh, [](const glm::dvec3& centre) { return centre.x > 3.0; });
    paint(mesh, [](const glm::dvec3& centre) { return centre.x < 3.0 && centre.y > 3.0; });
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    const auto isMiddle = [&](const RemovalStep& step)
    { return mesh.positions[step.position] == glm::dvec3(3.0, 3.0, 0.0); };
    EXPECT_TRUE(std::none_of(sequence.steps.begin(), sequence.steps.end(), isMiddle));
    EXPECT_GE(leftBy(sequence, RemovalRefusal::seamCorner), 1u);
}

TEST(RemoveVertices, TheLastFaceOfAMaterialStays)
{
    Mesh mesh = grid(10, 10);
    paint(mesh, [](const glm::dvec3& centre) { return glm::length(centre - glm::dvec3(5.1, 5.2, 0)) < 0.5; });
    const RemovalSequence sequence = removeVertices(mesh);
    const Mesh last = meshAfter(mesh, sequence, sequence.steps.size()).mesh;
    std::set<std::uint32_t> materials;
    for (const Face& face : last.faces)
        materials.insert(face.material);
    EXPECT_EQ(materials.size(), 2u);
}

TEST(RemoveVertices, AHoleIsNotTornOpenButCloses)
{
    Mesh mesh = grid(8, 8);
    std::erase_if(mesh.faces, [&](const Face& face)
                  { return glm::length(mesh.at(face, 0) - glm::dvec3(4, 4, 0)) < 0.1; });
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_LE(sequence.facesAfter(sequence.steps.size()), 2u);
}

/// A ball, and a cube of a fifth of its size beside it.
Mesh ballAndCube()
{
    Mesh mesh = ball(9, 16);
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh small = cube();
    for (const glm::dvec3& p : small.positions)
    {
        mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(glm::dvec3(3.0, 0.0, 0.0) + 0.2 * p);
    }
    for (Face face : small.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += first;
        mesh.faces.push_back(face);
    }
    return mesh;
}

TEST(RemoveVertices, APartGoesAtTheErrorOfItsSize)
{
    const Mesh mesh = ballAndCube();
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_EQ(sequence.steps.size(), sequence.positionCount - 4) << "of the ball a tetrahedron is left";
    bool isCubeGone = false;
    for (const RemovalStep& step : sequence.steps)
        if (step.isOfPart)
        {
            isCubeGone = true;
            EXPECT_GE(step.error, 0.2 * std::sqrt(3.0) - 1e-12);
            EXPECT_GT(mesh.positions[step.position].x, 2.0);
        }
    EXPECT_TRUE(isCubeGone);
    const RemovalSequence kept = removeVertices(mesh, {.removeParts = false});
    ASSERT_EQ(removalDefectOf(kept, mesh), "");
    EXPECT_EQ(kept.steps.size(), kept.positionCount - 8);
}

TEST(RemoveVertices, APartWithASupportVertexStays)
{
    const Mesh mesh = ballAndCube();
    RemovalOptions options;
    options.isSupport.resize(mesh.positions.size(), false);
    options.isSupport.back() = true;
    const RemovalSequence sequence = removeVertices(mesh, options);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    for (const RemovalStep& step : sequence.steps)
        EXPECT_TRUE(!step.isOfPart || mesh.positions[step.position].x < 2.0) << "the ball may go";
}

TEST(RemoveVertices, AStarOfTooManyFacesWaitsForItsNeighbours)
{
    const std::uint32_t sides = 300;
    ASSERT_GT(sides, kMostStarFaces);
    Mesh mesh = ball(3, sides);
    const RemovalSequence sequence = removeVertices(mesh);
    ASSERT_EQ(removalDefectOf(sequence, mesh), "");
    EXPECT_EQ(sequence.steps.size(), mesh.positions.size() - 4);
}

TEST(RemoveVertices, ACrowdedEdgeStaysAsItIs)
{
    // Three sheets that meet at one line, two squares high.
    std::vector<glm::dvec3> positions = {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}};
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t page = 0; page < 3; ++page)
    {
        for (int h = 0; h < 3; ++h)
            positions.emplace_back(std::cos(2.0 * page), std::sin(2.0 * page), h);
        for (std::uint32_t h = 0; h < 2; ++h)
        {
            const std::uint32_t a = h, b = 3 + 3 * page + h;
            faces.push_back({a, b, a + 1});
            faces.push_back({b, b + 1, a + 1});
        }
    }
    const Mesh book = meshOf(positions, faces);
    const RemovalSequence sequence = removeVertices(book);
    ASSERT_EQ(removalDefectOf(sequence, book), "");
    for (const RemovalStep& step : sequence.steps)
        EXPECT_GE(step.position, 3u) << "the spine has no order of faces";
    EXPECT_EQ(leftBy(sequence, RemovalRefusal::nonManifold), 3u);
}

TEST(RemoveVertices, AnySoupOfFacesKeepsItsSequenceSound)
{
    for (std::uint64_t seed = 1; seed <= 400; ++seed)
    {
        const auto positions = static_cast<std::uint32_t>(4 + seed % 23);
        const Mesh soup = faceSoup(seed, positions, static_cast<std::uint32_t>(1 + seed % 60));
        const RemovalSequence sequence = removeVertices(soup);
        ASSERT_EQ(removalDefectOf(sequence, soup), "") << "seed " << seed;
        const Mesh last = meshAfter(soup, sequence, sequence.steps.size()).mesh;
        ASSERT_EQ(defectOf(last), "");
        ASSERT_LE(countMesh(last).nonManifoldEdges, countMesh(soup).nonManifoldEdges) << "seed " << seed;
    }
}

TEST(RemoveVertices, AnEmptyMeshHasNoSteps)
{
    const Mesh mesh = meshOf({}, {});
    const RemovalSequence sequence = removeVertices(mesh);
    EXPECT_TRUE(sequence.steps.empty());
    EXPECT_TRUE(isSequenceOf(sequence, mesh));
    EXPECT_TRUE(meshAfter(mesh, sequence, 1).isClamped);
}

TEST(RemoveVertices, TheErrorOfABallsLevelsIsThatWhichIsMeasured)
{
    Mesh mesh = ball(21, 32);
    const RemovalSequence sequence = removeVertices(mesh);
    for (const double share : {0.5, 0.25, 0.1, 0.05})
    {
        const auto faces = static_cast<std::size_t>(share * static_cast<double>(mesh.faces.size()));
        const std::size_t steps = sequence.stepsToFaces(faces);
        const double measured = surfaceChange(mesh, meshAfter(mesh, sequence, steps).mesh).largest;
        EXPECT_LE(measured, sequence.steps[steps - 1].error) << share;
        EXPECT_GE(4.0 * measured, sequence.steps[steps - 1].error) << share;
    }
}

} // namespace
