// SPDX-License-Identifier: Apache-2.0
// Consolidation never makes a count of defects worse.
#include "UndoRepairs.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "Foliage.h"
#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::crown;
using testsupport::LeafKind;
using testsupport::meshOf;

/// Two squares with a T-junction each, far from one another: vertices 4 and 10 lie on the edges 1–2 and 7–8.
Mesh twoCracks()
{
    std::vector<glm::dvec3> positions;
    for (const double x : {0.0, 10.0})
        for (const glm::dvec3& p :
             {glm::dvec3(0, 0, 0), {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {2, 1, 0}, {3, 1, 0}})
            positions.push_back(p + glm::dvec3(x, 0, 0));
    return meshOf(positions, {{0, 1, 2}, {0, 2, 3}, {4, 5, 2}, {6, 7, 8}, {6, 8, 9}, {10, 11, 8}});
}

/// Puts vertex `number` into the edge of the first face of a square.
void repair(Mesh& mesh, std::vector<std::uint32_t>& origins, std::uint32_t face, std::uint32_t number)
{
    const auto at = std::find(origins.begin(), origins.end(), face) - origins.begin();
    Face piece = mesh.faces[std::size_t(at)];
    mesh.faces[std::size_t(at)].wedges[2] = number;
    piece.wedges[1] = number;
    mesh.faces.insert(mesh.faces.begin() + at + 1, piece);
    origins.insert(origins.begin() + at + 1, face);
}

TEST(UndoRepairs, LeavesRepairsThatMakeNothingWorse)
{
    const Mesh before = twoCracks();
    ASSERT_EQ(countMesh(before).tJunctions, 2u);
    Mesh mesh = before;
    std::vector<std::uint32_t> origins{0, 1, 2, 3, 4, 5};
    repair(mesh, origins, 0, 4);
    repair(mesh, origins, 3, 10);
    const Mesh repaired = mesh;
    EXPECT_EQ(undoWorseRepairs(mesh, before, origins), 0u);
    EXPECT_EQ(mesh.faces, repaired.faces);
    EXPECT_EQ(countMesh(mesh).tJunctions, 0u);
}

/// Mutations: each makes one count worse in one of the two groups.
TEST(UndoRepairs, GivesBackTheGroupWhereACountGotWorse)
{
    const std::vector<void (*)(Mesh&, std::vector<std::uint32_t>&)> mutations{
        [](Mesh& mesh, std::vector<std::uint32_t>& origins) // a degenerate face
        {
            mesh.faces.push_back({{11, 8, 8}, 0, 0}), origins.push_back(5);
        },
        [](Mesh& mesh, std::vector<std::uint32_t>& origins) // a duplicate
        { mesh.faces.push_back(mesh.faces.back()), origins.push_back(5); },
        [](Mesh& mesh, std::vector<std::uint32_t>& origins) // a crowded edge
        {
            mesh.faces.push_back({{6, 8, 11}, 0, 0}), origins.push_back(5);
        },
        [](Mesh& mesh, std::vector<std::uint32_t>&) // a second vertex in a T-junction
        {
            mesh.positions[11] = {11.0, 2.0, 0.0};
        }};
    for (std::size_t i = 0; i < mutations.size(); ++i)
    {
        const Mesh before = twoCracks();
        Mesh mesh = before;
        std::vector<std::uint32_t> origins{0, 1, 2, 3, 4, 5};
        repair(mesh, origins, 0, 4);
        mutations[i](mesh, origins);
        EXPECT_EQ(undoWorseRepairs(mesh, before, origins), 3u) << i;
        EXPECT_EQ(origins, (std::vector<std::uint32_t>{0, 0, 1, 2, 3, 4, 5})) << i;
        EXPECT_EQ(defectOf(mesh), "") << i;
        const MeshCounts counts = countMesh(mesh);
        EXPECT_EQ(counts.tJunctions, 1u) << i;
        EXPECT_EQ(counts.degenerates + counts.duplicates + counts.nonManifoldEdges, 0u) << i;
    }
}

/// Vertex 5 of the first group is on an edge of the second: what is given back to one might open a crack in
/// the other.
TEST(UndoRepairs, TakesBothSidesOfATJunctionForOneGroup)
{
    Mesh before = twoCracks();
    for (std::size_t p = 6; p < 12; ++p)
        before.positions[p].x -= 7.0;
    ASSERT_EQ(countMesh(before).tJunctions, 3u);
    Mesh mesh = before;
    for (std::size_t p = 6; p < 12; ++p)
        mesh.positions[p].x += 1.0;
    std::vector<std::uint32_t> origins{0, 1, 2, 3, 4, 5, 5};
    mesh.faces.push_back(mesh.faces.back());
    EXPECT_EQ(undoWorseRepairs(mesh, before, origins), 6u);
    EXPECT_EQ(mesh.positions, before.positions);
}

/// Cards that are closer to each other than the tolerance, in a scene that is large against them.
TEST(Consolidate, NeverAddsDefectsToCrowdedCards)
{
    int undone = 0;
    for (int cards = 20; cards <= 140; cards += 20)
        for (const double size : {2e-5, 1e-4})
        {
            Mesh mesh = crown(LeafKind::quad, cards, size / 5e-5);
            for (glm::dvec3& p : mesh.positions)
                p *= 5e-5;
            mesh = testsupport::together(mesh, crown(LeafKind::triangle, 1, 0.5), {0.5, 0.0, 0.0});
            const MeshCounts before = countMesh(mesh);
            const ConsolidateReport report = consolidate(mesh);
            undone += report.facesAsTheyWere > 0;
            const MeshCounts after = countMesh(mesh);
            EXPECT_LE(after.tJunctions, before.tJunctions) << cards << ' ' << size;
            EXPECT_LE(after.degenerates, before.degenerates) << cards << ' ' << size;
            EXPECT_LE(after.duplicates, before.duplicates) << cards << ' ' << size;
            EXPECT_LE(after.nonManifoldEdges, before.nonManifoldEdges) << cards << ' ' << size;
        }
    EXPECT_GT(undone, 0) << "otherwise there was little to see";
}

/// Triangles that meet at 27 places, with their corners there up to `spread` away from the place.
Mesh knots(std::uint64_t seed, double spread)
{
    testsupport::Random random(seed);
    const auto off = [&] { return glm::dvec3(random.unit(), random.unit(), random.unit()) * 2.0 - 1.0; };
    std::vector<glm::dvec3> positions;
    std::vector<Triangle> triangles;
    for (std::uint32_t place = 0; place < 27; ++place)
        for (int card = 0; card < 6; ++card)
        {
            const glm::dvec3 at(place % 3, place / 3 % 3, place / 9);
            const auto first = static_cast<std::uint32_t>(positions.size());
            positions.insert(positions.end(), {at + spread * off(), at + 0.1 * off(), at + 0.1 * off()});
            triangles.push_back({first, first + 1, first + 2});
        }
    return meshOf(positions, triangles);
}

/// Such vertices are merged, though they lie farther from one another than a position may move elsewhere;
/// what merges them pair by pair would leave some where they have moved as far as that, and cut their faces
/// until the limit of passes.
TEST(Consolidate, LeavesNoTJunctionInAKnot)
{
    std::size_t before = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed)
    {
        Mesh mesh = knots(seed, 3.0e-5);
        before += countMesh(mesh).tJunctions;
        const ConsolidateReport report = consolidate(mesh);
        EXPECT_EQ(report.facesAsTheyWere, 0u) << seed;
        EXPECT_EQ(countMesh(mesh).tJunctions, 0u) << seed;
    }
    EXPECT_GT(before, 40u) << "otherwise there was little to see";
}

/// `faces` triangles between random ones of some positions.
Mesh randomFaces(const std::vector<glm::dvec3>& positions, std::uint32_t faces)
{
    testsupport::Random random(5);
    const auto count = static_cast<std::uint32_t>(positions.size());
    std::vector<Triangle> triangles;
    while (triangles.size() < faces)
    {
        const Triangle t{random.below(count), random.below(count), random.below(count)};
        if (!repeatsCorner(t)) triangles.push_back(t);
    }
    return meshOf(positions, triangles);
}

void expectNoCountWorse(Mesh mesh)
{
    const MeshCounts before = countMesh(mesh);
    const ConsolidateReport report = consolidate(mesh);
    const MeshCounts after = countMesh(mesh);
    EXPECT_GT(report.facesAsTheyWere, 0u) << "otherwise there was little to see";
    EXPECT_LE(after.tJunctions, before.tJunctions);
    EXPECT_LE(after.degenerates, before.degenerates);
    EXPECT_LE(after.duplicates, before.duplicates);
    EXPECT_LE(after.nonManifoldEdges, before.nonManifoldEdges);
}

/// On a plane's grid edges cross by the thousand: inserting all vertices would add too many faces.
TEST(Consolidate, NeverAddsDefectsWhereTooManyEdgesCross)
{
    constexpr std::uint32_t kSide = 40;
    std::vector<glm::dvec3> positions;
    for (std::uint32_t i = 0; i < kSide * kSide; ++i)
        positions.emplace_back(i % kSide, i / kSide, 0.0);
    expectNoCountWorse(randomFaces(positions, 3000));
}

Mesh latticeOfRandomFaces(std::uint32_t side, std::uint32_t faces)
{
    std::vector<glm::dvec3> positions;
    for (std::uint32_t i = 0; i < side * side * side; ++i)
        positions.emplace_back(i % side, i / side % side, i / side / side);
    return randomFaces(positions, faces);
}

/// In a lattice hardly any edge is open before it is split from the others on it; then a hundred vertices lie
/// at each place. Searches for T-junctions look at a place once, and come to their end.
TEST(Consolidate, MendsALatticeWhoseVerticesLieOnEachOther)
{
    Mesh mesh = latticeOfRandomFaces(5, 30'000);
    const MeshCounts before = countMesh(mesh);
    EXPECT_GT(before.nonManifoldEdges, 1000u);
    EXPECT_EQ(consolidate(mesh).facesAsTheyWere, 0u); // 30 000 when they looked at each vertex
    const MeshCounts after = countMesh(mesh);
    EXPECT_EQ(after.tJunctions, 0u);
    EXPECT_EQ(after.nonManifoldEdges, 0u);
    EXPECT_EQ(after.duplicates, 0u);
    EXPECT_LE(after.degenerates, before.degenerates);
}

} // namespace
