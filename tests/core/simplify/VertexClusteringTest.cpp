// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <osgPMObjects/core/mesh/EdgeTable.h>
#include <osgPMObjects/core/mesh/MeshCheck.h>
#include <osgPMObjects/core/mesh/TriangleTree.h>
#include <osgPMObjects/core/simplify/VertexClustering.h>

#include "ClosedMeshes.h"

namespace
{

using namespace osgPMObjects::core;
using namespace testsupport;

/// The faces of a clustered mesh, and its edges and points as faces without area.
std::vector<Triangle> everythingOf(const ClusteredMesh& clustered)
{
    std::vector<Triangle> all = positionTriangles(clustered.mesh);
    for (const auto& [a, b] : clustered.edges)
        all.push_back({a, b, b});
    for (const std::uint32_t p : clustered.points)
        all.push_back({p, p, p});
    return all;
}

/// Returns the largest distance from points of the first mesh to the second, with a grid of points in each
/// triangle.
double farthest(std::span<const glm::dvec3> positions, const std::vector<Triangle>& from,
                const std::vector<Triangle>& to)
{
    const TriangleTree tree(positions, to);
    double largest = 0.0;
    const int steps = 5;
    for (const Triangle& t : from)
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j)
            {
                const double u = double(i) / steps, v = double(j) / steps;
                const glm::dvec3 p =
                    (1.0 - u - v) * positions[t[0]] + u * positions[t[1]] + v * positions[t[2]];
                largest = std::max(largest, tree.distance(p));
            }
    return largest;
}

ClusteredMesh clustered(const Mesh& mesh, double cellSize)
{
    auto result = clusterVertices(mesh, cellSize);
    EXPECT_TRUE(result) << result.error().message();
    return *result;
}

TEST(VertexClustering, ARowOfTrianglesByHand)
{
    // Cells of size 1 along x: {0, 1}, {2, 3}, {4}. Position 1 has the longest edge of its cell, 2 the
    // sharper corner of its cell.
    const Mesh mesh = meshOf({{0.0, 0, 0}, {0.9, 0, 0}, {1.1, 0.9, 0}, {1.2, 0.2, 0}, {3.5, 0.4, 0}},
                             {{0, 1, 2}, {1, 3, 2}, {3, 4, 2}});
    const ClusteredMesh coarse = clustered(mesh, 1.0);
    EXPECT_EQ(coarse.cells, 3u);
    EXPECT_EQ(coarse.representative[0], coarse.representative[1]);
    EXPECT_EQ(coarse.representative[2], coarse.representative[3]);
    EXPECT_EQ(coarse.representative[4], 4u);
    EXPECT_EQ(coarse.degenerateFaces, 3u);
    EXPECT_TRUE(coarse.mesh.faces.empty());
    EXPECT_EQ(coarse.edges.size(), 2u) << "a line of three positions is left";
    EXPECT_TRUE(coarse.points.empty());
    EXPECT_EQ(clusteringDefectOf(coarse, mesh), "");
}

TEST(VertexClustering, SmallPartsBecomePoints)
{
    Mesh mesh = cube();
    for (glm::dvec3& p : mesh.positions)
        p *= 0.1;
    const ClusteredMesh point = clustered(mesh, 1.0);
    EXPECT_EQ(point.degenerateFaces, 12u);
    EXPECT_EQ(point.points.size(), 1u);
    EXPECT_TRUE(point.edges.empty());
}

TEST(VertexClustering, ATipWeighsMoreThanAPlainAndALargeFaceMoreThanASmallOne)
{
    const Mesh tent =
        meshOf({{0, 0, 9}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}, {2, 2, 0}, {-3, 2, 0}, {0, -4, 0}},
               {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 4, 2}, {2, 5, 3}, {3, 6, 1}});
    const auto grades = clusterGrades(tent);
    EXPECT_EQ(std::max_element(grades.begin(), grades.end()), grades.begin());
    const auto small = clusterGrades(grid(2, 2));
    Mesh wide = grid(2, 2);
    for (glm::dvec3& p : wide.positions)
        p *= 3.0;
    EXPECT_NEAR(clusterGrades(wide)[4], 3.0 * small[4], 1e-12);
    EXPECT_NEAR(small[4], std::sqrt(2.0) / std::acos(-1.0), 1e-12)
        << "the longest edge is a diagonal, the largest angle is straight";
}

TEST(VertexClustering, OfManyEdgesTheAngleIsNotUnderestimated)
{
    const Mesh fine = ball(3, 300), coarse = ball(3, 60);
    EXPECT_LE(clusterGrades(fine)[0], clusterGrades(coarse)[0] * 1.01);
}

class VertexClusteringOf : public testing::TestWithParam<double>
{
};

TEST_P(VertexClusteringOf, NoPointMovesFartherThanACellsDiagonal)
{
    const double size = GetParam(), diagonal = std::sqrt(3.0) * size;
    for (const Mesh& mesh : {ball(30, 48), torus(40, 24), griddedCube(9), faceSoup(3, 60, 90)})
    {
        const ClusteredMesh coarse = clustered(mesh, size);
        ASSERT_EQ(clusteringDefectOf(coarse, mesh), "");
        ASSERT_EQ(defectOf(coarse.mesh), "");
        EXPECT_EQ(coarse.mesh.faces.size() + coarse.degenerateFaces + coarse.duplicateFaces,
                  mesh.faces.size());
        const auto before = positionTriangles(mesh), after = everythingOf(coarse);
        EXPECT_LE(farthest(mesh.positions, before, after), diagonal);
        EXPECT_LE(farthest(mesh.positions, after, before), diagonal);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, VertexClusteringOf, testing::Values(0.02, 0.11, 0.3, 0.77, 2.5));

TEST(VertexClustering, WithoutItsEdgesAThinPartWouldBeLost)
{
    // A strip 0.1 wide and 9 long becomes a line.
    std::vector<glm::dvec3> positions;
    std::vector<std::array<std::uint32_t, 3>> faces;
    for (std::uint32_t i = 0; i < 10; ++i)
    {
        positions.emplace_back(i + 0.5, 0.4, 0.0);
        positions.emplace_back(i + 0.5, 0.5, 0.0);
        if (i == 0) continue;
        faces.push_back({2 * i - 2, 2 * i, 2 * i - 1});
        faces.push_back({2 * i, 2 * i + 1, 2 * i - 1});
    }
    const Mesh strip = meshOf(positions, faces);
    ClusteredMesh line = clustered(strip, 1.0);
    EXPECT_EQ(line.edges.size(), 9u);
    const auto before = positionTriangles(strip);
    EXPECT_LE(farthest(strip.positions, before, everythingOf(line)), std::sqrt(3.0));
    line.edges.resize(2);
    EXPECT_GT(farthest(strip.positions, before, everythingOf(line)), std::sqrt(3.0));
    EXPECT_NE(clusteringDefectOf(line, strip), "");
}

TEST(VertexClustering, CornersKeepTheirAttributesAndMaterials)
{
    Mesh mesh = ball(15, 24);
    paint(mesh, [](const glm::dvec3& centre) { return centre.z > 0.0; });
    for (std::size_t w = 0; w < mesh.wedgeCount(); ++w)
        mesh.texCoords[0].emplace_back(static_cast<float>(w), 0.0f);
    const ClusteredMesh coarse = clustered(mesh, 0.4);
    EXPECT_EQ(coarse.mesh.texCoords[0], mesh.texCoords[0]);
    for (const Face& face : coarse.mesh.faces)
        for (const std::uint32_t wedge : face.wedges)
            EXPECT_EQ(wedge >= 362, face.material == 1) << "no wedge of the other half";
}

TEST(VertexClustering, SidesOfAThinSheetBothStayAndRepeatedFacesDoNot)
{
    Mesh sheet = grid(1, 1);
    sheet.faces.push_back(sheet.faces[0]);
    sheet.faces.push_back(
        {{sheet.faces[0].wedges[0], sheet.faces[0].wedges[2], sheet.faces[0].wedges[1]}, 0, 0});
    const ClusteredMesh same = clustered(sheet, 0.5);
    EXPECT_EQ(same.duplicateFaces, 1u);
    EXPECT_EQ(same.mesh.faces.size(), 3u);
}

TEST(VertexClustering, TheCheckSeesEveryMutation)
{
    const Mesh mesh = ball(20, 32);
    const ClusteredMesh sound = clustered(mesh, 0.3);
    ASSERT_EQ(clusteringDefectOf(sound, mesh), "");
    std::uint32_t near = 0;
    while (sound.representative[near] == near)
        ++near;
    const std::vector<std::function<void(ClusteredMesh&)>> mutations = {
        [&](ClusteredMesh& c) { c.representative[near] = c.representative[1]; },    // another cell's
        [&](ClusteredMesh& c) { c.representative[near] = near; },                   // moved nowhere
        [&](ClusteredMesh& c) { c.representative[c.representative[near]] = near; }, // in a circle
        [&](ClusteredMesh& c) { c.representative[near] = ~0u; },
        [&](ClusteredMesh& c) { c.representative.pop_back(); },
        [&](ClusteredMesh& c) { c.cellSize *= 0.5; },
        [&](ClusteredMesh& c) { c.mesh.faces.pop_back(); },
        [&](ClusteredMesh& c) { c.mesh.positions[near].x += 1.0; },
        [&](ClusteredMesh& c) { ++c.degenerateFaces; },
        [&](ClusteredMesh& c) { ++c.duplicateFaces; },
        [&](ClusteredMesh& c) { c.points.push_back(0); },
    };
    for (std::size_t i = 0; i < mutations.size(); ++i)
    {
        ClusteredMesh mutated = sound;
        mutations[i](mutated);
        EXPECT_NE(clusteringDefectOf(mutated, mesh), "") << i;
    }
}

TEST(VertexClustering, CellSizesThatAreNoneAreRefused)
{
    for (const double size : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity(), 1e-12})
        EXPECT_FALSE(clusterVertices(cube(), size)) << size;
    EXPECT_TRUE(clusterVertices(meshOf({}, {}), 1.0));
}

} // namespace
