// SPDX-License-Identifier: Apache-2.0
#include <random>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/CloseCracks.h>
#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>
#include <osgPMObjects/core/mesh/SurfaceChange.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::cube;
using testsupport::grid;
using testsupport::meshOf;

/// A mesh without shared vertices: each corner has a position and a wedge of its own, displaced by up to `noise`.
Mesh soup(const Mesh& whole, double noise, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-noise, noise);
    Mesh mesh = whole;
    mesh.positions.clear();
    mesh.wedgePositions.clear();
    for (Face& face : mesh.faces)
        for (std::uint32_t& wedge : face.wedges)
        {
            mesh.positions.push_back(whole.positions[whole.wedgePositions[wedge]] +
                                     glm::dvec3(off(random), off(random), off(random)));
            wedge = static_cast<std::uint32_t>(mesh.wedgePositions.size());
            mesh.wedgePositions.push_back(wedge);
        }
    return mesh;
}

double volumeOf(const Mesh& mesh)
{
    double six = 0.0;
    for (const Face& f : mesh.faces)
        six += glm::dot(mesh.at(f, 0), glm::cross(mesh.at(f, 1), mesh.at(f, 2)));
    return six / 6.0;
}

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

TEST(Orient, ATurnedFaceOfACubeIsTurnedBack)
{
    for (std::uint32_t f = 0; f < 12; ++f)
    {
        Mesh mesh = cube();
        std::swap(mesh.faces[f].wedges[1], mesh.faces[f].wedges[2]);
        const Orientation report = orientFaces(mesh);
        EXPECT_EQ(report.turnedFaces, 1u) << f;
        EXPECT_EQ(report.disagreements, 0u) << f;
        EXPECT_NEAR(volumeOf(mesh), 1.0, 1e-12) << f;
    }
}

TEST(Orient, ASheetFollowsItsLargestPatch)
{
    Mesh mesh = grid(6, 6);
    for (const std::uint32_t f : {10u, 11u, 30u})
        std::swap(mesh.faces[f].wedges[1], mesh.faces[f].wedges[2]);
    orientFaces(mesh);
    for (const Face& face : mesh.faces)
        EXPECT_GT(glm::cross(mesh.at(face, 1) - mesh.at(face, 0), mesh.at(face, 2) - mesh.at(face, 0)).z,
                  0.0);
}

TEST(Orient, NormalsTurnWithAFaceUnlessTheyWereRight)
{
    Mesh mesh = grid(1, 1);
    mesh.normals.assign(4, {0.0f, 0.0f, 1.0f});
    turnFace(mesh, 0, true);
    EXPECT_EQ(mesh.normals[mesh.faces[0].wedges[0]].z, -1.0f);
    EXPECT_EQ(mesh.normals[mesh.faces[1].wedges[0]].z, 1.0f) << "its neighbour keeps them";
    mesh = grid(1, 1);
    mesh.normals.assign(4, {0.0f, 0.0f, -1.0f});
    turnFace(mesh, 0, true);
    EXPECT_EQ(mesh.normals[mesh.faces[0].wedges[0]].z, -1.0f);
}

TEST(Orient, AMobiusStripIsCutNotForced)
{
    constexpr std::uint32_t kSteps = 24;
    std::vector<glm::dvec3> positions;
    for (std::uint32_t i = 0; i < kSteps; ++i)
        for (const double side : {-0.3, 0.3})
        {
            const double angle = 6.283185307179586 * i / kSteps, half = 0.5 * angle;
            positions.emplace_back((1.0 + side * std::cos(half)) * std::cos(angle),
                                   (1.0 + side * std::cos(half)) * std::sin(angle), side * std::sin(half));
        }
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t i = 0; i < kSteps; ++i)
    {
        const std::uint32_t a = 2 * i, b = a + 1;
        const bool closes = i + 1 == kSteps;
        const std::uint32_t c = closes ? 1 : a + 2, d = closes ? 0 : a + 3;
        faces.push_back({a, c, b});
        faces.push_back({b, c, d});
    }
    Mesh mesh = meshOf(positions, faces);
    const Orientation report = orientFaces(mesh);
    EXPECT_GE(report.disagreements, 1u);
    EXPECT_GT(splitNonManifoldEdges(mesh).copies, 0u);
    EXPECT_EQ(orientFaces(mesh).disagreements, 0u);
}

TEST(InsideOut, TurnsABodyButNotAHollow)
{
    Mesh mesh = cube();
    for (std::uint32_t f = 0; f < 12; ++f)
        turnFace(mesh, f, true);
    EXPECT_EQ(turnInsideOut(mesh).turnedGroups, 1u);
    EXPECT_NEAR(volumeOf(mesh), 1.0, 1e-12);
    EXPECT_EQ(turnInsideOut(mesh).turnedGroups, 0u);

    const auto outer = static_cast<std::uint32_t>(mesh.positions.size());
    const Mesh inner = cube();
    for (const glm::dvec3& p : inner.positions)
    {
        mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(0.25 + 0.5 * p);
    }
    for (Face face : inner.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += outer;
        std::swap(face.wedges[1], face.wedges[2]);
        mesh.faces.push_back(face);
    }
    const InsideOut report = turnInsideOut(mesh);
    EXPECT_EQ(report.cavities, 1u);
    EXPECT_EQ(report.turnedGroups, 0u);
}

TEST(SplitEdges, TwoCubesOnOneEdgeComeApart)
{
    Mesh mesh = cube();
    const Mesh other = cube();
    for (Face face : other.faces)
    {
        for (std::uint32_t& wedge : face.wedges)
            wedge += 8;
        mesh.faces.push_back(face);
    }
    for (const glm::dvec3& p : other.positions)
    {
        mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(p + glm::dvec3(1, 1, 0));
    }
    weldPositions(mesh, 1e-9);
    EXPECT_EQ(countMesh(mesh).nonManifoldEdges, 1u);
    const SplitEdges report = splitNonManifoldEdges(mesh);
    EXPECT_EQ(report.crowded, 1u);
    const MeshCounts after = countMesh(mesh);
    EXPECT_EQ(after.nonManifoldEdges, 0u);
    EXPECT_EQ(after.boundaryEdges, 0u) << "each cube stays closed";
    EXPECT_EQ(after.positions, 16u);
}

TEST(Normals, CreaseAngleAndSmoothingGroupsDecide)
{
    Mesh smooth = cube();
    EXPECT_EQ(computeNormals(smooth, {.creaseAngleDeg = 100.0, .groups = {}}), 12u);
    for (const Face& face : smooth.faces)
        for (int i = 0; i < 3; ++i)
        {
            const glm::dvec3 out = glm::normalize(smooth.at(face, i) - 0.5);
            EXPECT_NEAR(glm::dot(out, glm::dvec3(smooth.normals[face.wedges[static_cast<std::size_t>(i)]])),
                        1.0, 1e-6)
                << "by angles a cube's corner points along its diagonal, however its sides are cut";
        }
    Mesh sharp = cube();
    computeNormals(sharp, {.creaseAngleDeg = 45.0, .groups = {}});
    mergeWedges(sharp);
    EXPECT_EQ(sharp.wedgeCount(), 24u);
    Mesh grouped = cube();
    const std::vector<std::uint32_t> oneGroup(12, 4), none(12, 0);
    computeNormals(grouped, {.creaseAngleDeg = 0.0, .groups = oneGroup});
    mergeWedges(grouped);
    EXPECT_EQ(grouped.wedgeCount(), 8u);
    computeNormals(grouped, {.creaseAngleDeg = 180.0, .groups = none, .onlyMissing = false});
    mergeWedges(grouped);
    EXPECT_EQ(grouped.wedgeCount(), 24u) << "each face by itself; the two of a side are alike";
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

/// A soup with `breaks` defects: duplicated, reversed, flat and stray faces, and corners moved to the middle of edges.
Mesh brokenSoup(unsigned seed, int breaks, unsigned side, double noise)
{
    std::mt19937 random(seed);
    Mesh mesh = soup(grid(side + random() % 6, side + random() % 6), noise, seed);
    for (int i = 0; i < breaks; ++i)
    {
        Face face = mesh.faces[random() % mesh.faces.size()];
        if (i % 4 == 0) std::swap(face.wedges[0], face.wedges[1]);
        if (i % 4 == 1) face.wedges[0] = face.wedges[1];
        if (i % 4 == 2)
        {
            mesh.positions.push_back(0.5 * (mesh.at(face, 0) + mesh.at(face, 1)));
            face.wedges[2] = static_cast<std::uint32_t>(mesh.wedgeCount());
            mesh.wedgePositions.push_back(static_cast<std::uint32_t>(mesh.positions.size() - 1));
        }
        if (i % 4 == 3) face.wedges[1] = static_cast<std::uint32_t>(random() % mesh.wedgeCount());
        mesh.faces.push_back(face);
    }
    return mesh;
}

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
