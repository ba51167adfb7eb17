// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "Random.h"
#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;

/// A refined mesh as plain arrays, to be damaged.
struct Drawn
{
    explicit Drawn(int columns, int rows)
        : tile(testsupport::planarTile(testsupport::hills(columns, rows))), mesh(tile)
    {
        mesh.refine(20.0);
        drawn = mesh.drawn();
    }

    DrawnMeshReport check() const { return checkDrawnMesh(*tile, drawn, nullptr); }

    std::shared_ptr<const RoamTile> tile;
    RoamMesh mesh;
    DrawnMesh drawn;
};

TEST(DrawnMeshCheck, FindsNothingInASoundMesh)
{
    for (const auto& [columns, rows] : {std::pair{33, 33}, {20, 33}, {33, 19}, {40, 21}})
    {
        const DrawnMeshReport report = Drawn(columns, rows).check();
        EXPECT_EQ(report.tJunctions, 0u) << columns << "x" << rows;
        EXPECT_EQ(report.cracks, 0u) << columns << "x" << rows;
    }
}

TEST(DrawnMeshCheck, SeesAMissingTriangle)
{
    Drawn drawn(33, 33);
    drawn.drawn.triangles.erase(drawn.drawn.triangles.begin() + 5);
    EXPECT_GT(drawn.check().tJunctions, 0u);
}

TEST(DrawnMeshCheck, CountsEdgesWithoutTwinAsAComparisonOfAllPairsDoes)
{
    // Vertices of their own for each triangle, as blocks have them: edges are the same where their ends lie
    // at the same places.
    Drawn drawn(33, 33);
    DrawnMesh mesh;
    mesh.stepM = drawn.drawn.stepM;
    testsupport::Random random(7);
    for (const LeafTriangle& t : drawn.drawn.triangles)
    {
        if (random.below(8) == 0) continue;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const std::uint32_t v : t.vertices)
        {
            mesh.vertices.push_back(drawn.drawn.vertices[v]);
            mesh.grid.push_back(drawn.drawn.grid[v]);
        }
        mesh.triangles.push_back({{first, first + 1, first + 2}});
    }
    std::vector<std::pair<GridPoint, GridPoint>> edges;
    for (const LeafTriangle& t : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            edges.emplace_back(mesh.grid[t.vertices[i]], mesh.grid[t.vertices[(i + 1) % 3]]);
    const auto isAtBorder = [](GridPoint a, GridPoint b)
    {
        return (a.column == b.column && (a.column == 0 || a.column == 32)) ||
               (a.row == b.row && (a.row == 0 || a.row == 32));
    };
    std::size_t open = 0;
    for (const auto& [from, to] : edges)
        if (!isAtBorder(from, to) &&
            std::find(edges.begin(), edges.end(), std::pair(to, from)) == edges.end())
            ++open;
    EXPECT_GT(open, 10u);
    EXPECT_EQ(checkDrawnMesh(*drawn.tile, mesh, nullptr).tJunctions, open);
}

TEST(DrawnMeshCheck, SeesAHoleInTheSamples)
{
    Drawn drawn(33, 33);
    drawn.mesh.refine(1e9);
    drawn.drawn.triangles.assign(1, drawn.drawn.triangles.front());
    EXPECT_GT(drawn.check().cracks, 0u);
}

TEST(DrawnMeshCheck, SeesAVertexOffItsPlace)
{
    Drawn drawn(33, 33);
    drawn.drawn.vertices[drawn.drawn.triangles[7].vertices[0]].position.z +=
        static_cast<int>(0.01 / drawn.drawn.stepM);
    EXPECT_GT(drawn.check().cracks, 0u);
}

TEST(DrawnMeshCheck, SeesATriangleThatIsTurnedOver)
{
    Drawn drawn(33, 33);
    std::swap(drawn.drawn.triangles[7].vertices[1], drawn.drawn.triangles[7].vertices[2]);
    EXPECT_GT(drawn.check().cracks, 0u);
}

TEST(DrawnMeshCheck, TakesTrianglesOfAnyShape)
{
    // A fan around a point that is in the middle of nothing.
    const auto tile = testsupport::planarTile(testsupport::hills(17, 17));
    DrawnMesh mesh;
    mesh.stepM = tile->tile.frame().vertexStepM();
    for (const GridPoint p : {GridPoint{5, 9}, {0, 0}, {16, 0}, {16, 16}, {0, 16}})
    {
        mesh.grid.push_back(p);
        mesh.vertices.push_back(meshVertex(tile->tile.position(p.column, p.row), p, mesh.stepM));
    }
    for (std::uint32_t i = 1; i <= 4; ++i)
        mesh.triangles.push_back({{0, i, i % 4 + 1}});
    const DrawnMeshReport sound = checkDrawnMesh(*tile, mesh, nullptr);
    EXPECT_EQ(sound.tJunctions + sound.cracks, 0u);
    mesh.triangles.pop_back();
    const DrawnMeshReport open = checkDrawnMesh(*tile, mesh, nullptr);
    EXPECT_GT(open.tJunctions, 0u);
    EXPECT_GT(open.cracks, 0u);
}

TEST(DrawnMeshCheck, AVertexThatBeginsToMoveTurnsATriangleOverOnlyBeyondRounding)
{
    // A fan whose middle begins at a corner: two triangles have no extent yet, but for rounding.
    const auto tile = testsupport::planarTile(testsupport::hills(17, 17));
    const double cellM = tile->tile.field().spacingEastM;
    const auto cracksWhenOff = [&](double offCells)
    {
        DrawnMesh mesh;
        mesh.isMorphed = true;
        mesh.stepM = 1e-6 * cellM;
        for (const GridPoint p : {GridPoint{5, 9}, {0, 0}, {16, 0}, {16, 16}, {0, 16}})
        {
            mesh.grid.push_back(p);
            mesh.vertices.push_back(meshVertex(tile->tile.position(p.column, p.row), p, mesh.stepM));
        }
        mesh.vertices[0] = meshVertex(tile->tile.position(0, 0) - glm::dvec3(0.0, offCells * cellM, 0.0),
                                      mesh.grid[0], mesh.stepM);
        for (std::uint32_t i = 1; i <= 4; ++i)
            mesh.triangles.push_back({{0, i, i % 4 + 1}});
        return checkDrawnMesh(*tile, mesh, nullptr).cracks;
    };
    EXPECT_EQ(cracksWhenOff(0.0), 0u);
    EXPECT_EQ(cracksWhenOff(2e-5), 0u) << "16 cells long: -3e-4 cells of area";
    EXPECT_GT(cracksWhenOff(0.05), 0u);
}

TEST(DrawnMeshCheck, SeesATJunction)
{
    Drawn drawn(33, 33);
    // Two neighbouring triangles become one large one of three corners: its long side has a vertex in it.
    const LeafTriangle t = drawn.drawn.triangles[3];
    drawn.drawn.triangles.push_back({{t.vertices[0], t.vertices[2], t.vertices[1]}});
    drawn.drawn.triangles.pop_back();
    drawn.drawn.triangles[3] = {{t.vertices[1], t.vertices[2], t.vertices[2]}};
    EXPECT_GT(drawn.check().tJunctions, 0u);
}

} // namespace
