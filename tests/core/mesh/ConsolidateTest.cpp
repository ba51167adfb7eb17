// SPDX-License-Identifier: Apache-2.0
// Consolidation: welding, faces that go, T-junctions, wedges, and the whole on random soups.
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>

#include "BrokenMeshes.h"
#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace brokenmeshes;
using testsupport::cube;
using testsupport::grid;
using testsupport::meshOf;

TEST(Weld, JoinsWhatIsNearAndMovesNothingFar)
{
    Mesh mesh = soup(grid(20, 20), 1e-4, 1);
    const std::vector<glm::dvec3> before = mesh.positions;
    weldPositions(mesh, 1e-3);
    EXPECT_EQ(countMesh(mesh).positions, 441u);
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
        EXPECT_LE(glm::length(mesh.positions[mesh.wedgePositions[w]] - before[w]), 1e-3);
    Mesh apart = soup(grid(20, 20), 1e-4, 1);
    weldPositions(apart, 1e-6);
    EXPECT_GT(countMesh(apart).positions, 2000u) << "the tolerance counts";
}

TEST(Weld, DoesNotCollapseChains)
{
    std::vector<glm::dvec3> line;
    for (int i = 0; i < 100; ++i)
        line.emplace_back(0.6 * i, 0.0, 0.0);
    Mesh mesh = meshOf(line, {});
    EXPECT_EQ(weldPositions(mesh, 1.0), 50u) << "every second one joins the one before";
}

TEST(Weld, TakesAPointFarAwayForOne)
{
    Mesh mesh = meshOf({{1e38, -1e38, 7.0}, {1e38, -1e38, 7.0}}, {});
    EXPECT_EQ(weldPositions(mesh, 0.0), 1u);
    mesh.faces.push_back({{0, 0, 1}, 0, 0});
    consolidate(mesh);
    EXPECT_TRUE(mesh.faces.empty());
    EXPECT_TRUE(isValid(mesh));
}

TEST(MeshCounts, CountsEachDefectOnce)
{
    // A unit square of two triangles, with a vertex of a third in the middle of its lower side.
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0, 0}, {0.2, -1, 0}, {0.8, -1, 0}},
                       {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}});
    EXPECT_EQ(countMesh(mesh).tJunctions, 1u);
    EXPECT_EQ(countMesh(mesh).components, 2u);
    EXPECT_EQ(countMesh(mesh).boundaryEdges, 7u);
    mesh.faces.push_back({{2, 1, 0}, 0, 0}); // the first, from behind
    EXPECT_EQ(countMesh(mesh).duplicates, 1u);
    EXPECT_EQ(countMesh(mesh).nonManifoldEdges, 1u);
    mesh.faces.push_back({{5, 5, 6}, 0, 0});
    mesh.positions.push_back({0.5, -1.0, 0});
    mesh.wedgePositions.push_back(7);
    mesh.faces.push_back({{5, 7, 6}, 0, 0});
    EXPECT_EQ(countMesh(mesh).degenerates, 2u);
}

TEST(RemoveFaces, KeepsOneOfEachAndSaysWhatWent)
{
    Mesh mesh = cube();
    mesh.faces.push_back(mesh.faces[3]);
    mesh.faces.push_back({{mesh.faces[0].wedges[1], mesh.faces[0].wedges[0], mesh.faces[0].wedges[2]}, 0, 0});
    const DuplicateFaces report = removeDuplicateFaces(mesh);
    EXPECT_EQ(report.removed, 1u);
    EXPECT_EQ(report.backToBack, 1u);
    EXPECT_EQ(mesh.faces.size(), 12u);
    EXPECT_TRUE(mesh.materials[mesh.faces[0].material].isTwoSided) << "it showed from both sides";
    EXPECT_FALSE(mesh.materials[mesh.faces[1].material].isTwoSided);
}

TEST(RemoveFaces, KeepsBacksOfAnotherLook)
{
    Mesh mesh = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}});
    mesh.materials.push_back({.name = "inside", .state = 1});
    mesh.faces[1].material = 1;
    EXPECT_EQ(removeDuplicateFaces(mesh).kept, 1u);
    EXPECT_EQ(mesh.faces.size(), 2u);
    mesh.materials[1].isTwoSided = true;
    EXPECT_EQ(removeDuplicateFaces(mesh).removed, 1u);
    EXPECT_EQ(mesh.faces.at(0).material, 1u) << "it is seen from both sides";
}

TEST(InsertTVertices, SplitsTheNeighbourAndInterpolatesAlongItsEdge)
{
    Mesh mesh =
        meshOf({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 0, 0}, {0, -2, 0}, {2, -2, 0}}, {{0, 1, 2}, {3, 4, 5}});
    mesh.texCoords[0] = {{0, 0}, {1, 0}, {0, 1}, {9, 9}, {9, 9}, {9, 9}};
    mesh.materials[0].attributes = Material::texCoord0;
    const Mesh before = mesh;
    const ConsolidateReport report = consolidate(mesh);
    EXPECT_EQ(report.tVertices.inserted, 1u);
    EXPECT_EQ(mesh.faces.size(), 3u);
    EXPECT_EQ(countMesh(mesh).tJunctions, 0u);
    EXPECT_LT(surfaceChange(before, mesh).largest, 1e-12);
    bool isFound = false;
    for (std::uint32_t w = 0; w < mesh.wedgeCount(); ++w)
        isFound = isFound || (mesh.positions[mesh.wedgePositions[w]] == glm::dvec3(1, 0, 0) &&
                              mesh.texCoords[0][w] == glm::vec2(0.25f, 0.0f));
    EXPECT_TRUE(isFound) << "a quarter of the way from (0, 0) to (1, 0)";
}

/// Squares beside squares of half the size: T-junctions at every second vertex.
TEST(InsertTVertices, ClosesAWholeSeam)
{
    Mesh mesh = grid(8, 4);
    const Mesh fine = grid(24, 4);
    const auto positions = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::dvec3& p : fine.positions)
    {
        mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.emplace_back(p.x / 3.0, p.y + 4.0, 0.0);
    }
    for (Face face : fine.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += positions;
        mesh.faces.push_back(face);
    }
    EXPECT_EQ(countMesh(mesh).tJunctions, 16u);
    const Mesh before = mesh;
    const ConsolidateReport report = consolidate(mesh);
    const MeshCounts after = countMesh(mesh);
    EXPECT_EQ(report.tVertices.inserted, 16u);
    EXPECT_EQ(after.tJunctions, 0u);
    EXPECT_EQ(after.components, 1u);
    EXPECT_EQ(after.boundaryEdges, 8u + 24u + 2u * 8u) << "only the outer border is left";
    EXPECT_LT(surfaceChange(before, mesh).largest, 1e-9);
}

TEST(MergeWedges, MergesWhatTheStateDoesNotTellApart)
{
    Mesh mesh = soup(grid(1, 1), 0.0, 1);
    weldPositions(mesh, 0.0);
    mesh.texCoords[0] = {{0, 0}, {1, 0}, {0, 1}, {5, 5}, {6, 6}, {7, 7}};
    mesh.materials[0].attributes = Material::texCoord0;
    Mesh seen = mesh;
    EXPECT_EQ(mergeWedges(seen).merged, 0u);
    EXPECT_EQ(seen.wedgeCount(), 6u);
    mesh.materials[0].unseen = Material::texCoord0;
    Mesh kept = mesh;
    EXPECT_EQ(mergeWedges(kept, {.dropUnseen = false}).merged, 0u);
    EXPECT_EQ(mergeWedges(mesh).merged, 2u);
    EXPECT_EQ(mesh.wedgeCount(), 4u);
    EXPECT_TRUE(isValid(mesh));
}

TEST(SurfaceChange, MeasuresAShiftAndAHole)
{
    const Mesh mesh = grid(4, 4);
    Mesh shifted = mesh;
    for (glm::dvec3& p : shifted.positions)
        p.z += 0.01;
    EXPECT_NEAR(surfaceChange(mesh, shifted).largest, 0.01, 1e-12);
    EXPECT_NEAR(surfaceChange(mesh, shifted).mean, 0.01, 1e-12);
    Mesh holed = mesh;
    holed.faces.erase(holed.faces.begin());
    EXPECT_GT(surfaceChange(mesh, holed).largest, 0.3);
    EXPECT_LT(surfaceChange(mesh, mesh).largest, 1e-14);
}

/// For any input the result is valid, near the input, and the same every time.
TEST(Consolidate, RandomSoupsComeOutSound)
{
    for (unsigned seed = 1; seed <= 60; ++seed)
    {
        Mesh mesh = brokenSoup(seed, 40, 3, seed % 3 == 0 ? 0.0 : 1e-7);
        const Mesh before = mesh;
        consolidate(mesh);
        ASSERT_EQ(defectOf(mesh), "") << seed;
        const MeshCounts after = countMesh(mesh);
        EXPECT_EQ(after.tJunctions, 0u) << seed;
        EXPECT_EQ(after.duplicates, 0u) << seed;
        EXPECT_EQ(after.degenerates, 0u) << seed;
        EXPECT_EQ(after.nonManifoldEdges, 0u) << seed;
        EXPECT_LE(surfaceChange(before, mesh, 2000).largest, 2e-5 * diagonalOf(before)) << seed;
        Mesh again = before;
        consolidate(again);
        ASSERT_EQ(again.faces, mesh.faces) << seed;
        ASSERT_EQ(again.positions, mesh.positions) << seed;
    }
}

} // namespace
