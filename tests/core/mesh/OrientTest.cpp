// SPDX-License-Identifier: Apache-2.0
// Which way faces look: neighbours that agree, bodies inside out, edges with too many faces, normals.
#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <osgPMObjects/core/consolidate/Consolidate.h>
#include <osgPMObjects/core/consolidate/Weld.h>
#include <osgPMObjects/core/mesh/MeshCounts.h>

#include "MadeMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::cube;
using testsupport::grid;
using testsupport::meshOf;

double volumeOf(const Mesh& mesh)
{
    double six = 0.0;
    for (const Face& f : mesh.faces)
        six += glm::dot(mesh.at(f, 0), glm::cross(mesh.at(f, 1), mesh.at(f, 2)));
    return six / 6.0;
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

} // namespace
