// SPDX-License-Identifier: Apache-2.0
// Tests what blocks that drop rows and columns do from frame to frame: changes, ceilings, morphing, edits,
// and queries of their surface.
#include <iostream>
#include <set>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>

#include "DecimatedFlight.h"
#include "RuggedTile.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::drawnSamples;
using testsupport::isSound;
using testsupport::pictured;
using testsupport::ruggedTile;
using testsupport::viewAt;

TEST(DecimatedChanges, IsAFunctionOfTheEye)
{
    const auto tile = ruggedTile();
    const PreparedDecimation prepared(tile);
    for (const bool morphs : {false, true})
    {
        const auto travelled = prepared.newMesh(), fresh = prepared.newMesh();
        travelled->setMorphing(morphs);
        fresh->setMorphing(morphs);
        for (int frame = 0; frame <= 200; frame += 10)
            travelled->refine(viewAt(*tile, frame), {.errorTolerancePx = 3.0});
        fresh->refine(viewAt(*tile, 200), {.errorTolerancePx = 3.0});
        EXPECT_EQ(pictured(*travelled), pictured(*fresh));
    }
}

TEST(DecimatedChanges, TheChangesLeadFromMeshToMesh)
{
    const auto tile = ruggedTile();
    const auto mesh = PreparedDecimation(tile).newMesh();
    std::vector<MeshVertex> vertices;
    std::vector<LeafTriangle> triangles;
    std::size_t written = 0, all = 0;
    for (int frame = 0; frame < 120; ++frame)
    {
        mesh->setMorphing(frame >= 80);
        mesh->refine(viewAt(*tile, frame), {.errorTolerancePx = 2.0});
        vertices.resize(mesh->vertexSlots());
        triangles.resize(mesh->triangleSlots());
        std::vector<MeshVertex> vertex;
        std::vector<LeafTriangle> triangle;
        for (const std::uint32_t slot : mesh->changes().vertices)
        {
            mesh->appendVertices({slot, 1}, vertex);
            vertices[slot] = vertex.back();
        }
        for (const std::uint32_t slot : mesh->changes().triangles)
        {
            mesh->appendTriangles({slot, 1}, triangle);
            triangles[slot] = triangle.back();
        }
        if (frame > 0 && frame < 80) written += mesh->changes().triangles.size();
        if (frame > 0 && frame < 80) all += mesh->drawn().triangles.size();
        const DrawnMesh wanted = mesh->drawn();
        std::size_t i = 0;
        for (const IndexRange& range : mesh->allRanges())
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot, ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    ASSERT_EQ(vertices[triangles[slot].vertices[k]],
                              wanted.vertices[wanted.triangles[i].vertices[k]]);
    }
    EXPECT_LT(written, all / 4) << "blocks that stay are written again";
    mesh->refine(viewAt(*tile, 119), {.errorTolerancePx = 2.0});
    EXPECT_TRUE(mesh->changes().vertices.empty() && mesh->changes().triangles.empty())
        << "the eye stands still";
}

TEST(DecimatedChanges, TheCeilingRaisesTheTolerance)
{
    const auto tile = ruggedTile();
    const PreparedDecimation prepared(tile);
    for (const bool morphs : {false, true})
    {
        const auto mesh = prepared.newMesh();
        mesh->setMorphing(morphs);
        for (int frame = 0; frame < 200; frame += 20)
        {
            const auto view = viewAt(*tile, frame);
            const RefineResult free = mesh->refine(view, {.errorTolerancePx = 0.5});
            const std::uint32_t most = std::max(free.leaves / 3, prepared.fewestTriangles());
            const RefineResult bound = mesh->refine(view, {.errorTolerancePx = 0.5, .maxTriangles = most});
            ASSERT_LE(bound.leaves, most);
            EXPECT_TRUE(bound.ceilingBound);
            EXPECT_FALSE(free.ceilingBound);
            EXPECT_GT(bound.tolerancePx, 0.5);
            ASSERT_TRUE(isSound(*mesh, view, bound.tolerancePx)) << frame;
        }
    }
}

/// The largest move of a sample's drawn place from one small step of the eye to the next, in pixels.
double largestJumpPx(bool morphs)
{
    const auto tile = ruggedTile();
    const auto mesh = PreparedDecimation(tile).newMesh();
    mesh->setMorphing(morphs);
    std::vector<glm::dvec3> before;
    double largestPx = 0.0;
    for (int step = 0; step < 240; ++step)
    {
        const auto view = viewAt(*tile, 20.0 + step / 60.0); // 0.75 m a step
        mesh->refine(view, {.errorTolerancePx = 3.0});
        const std::vector<glm::dvec3> now = drawnSamples(*mesh);
        for (std::size_t i = 0; i < before.size(); ++i)
            largestPx = std::max(largestPx, view.pixelsPerTangent * glm::distance(before[i], now[i]) /
                                                std::max(glm::distance(now[i], view.eyeWorld), view.nearM));
        before = now;
    }
    return largestPx;
}

TEST(DecimatedChanges, MorphingLeavesNoJumps)
{
    const double with = largestJumpPx(true), without = largestJumpPx(false);
    EXPECT_GT(without, 0.5) << "nothing ever jumps: nothing was checked";
    EXPECT_LT(with, 0.1 * without);
    std::cout << "largest jump of the drawn ground: " << with << " px with morphing, " << without
              << " px without\n";
}

TEST(DecimatedChanges, FollowsEdits)
{
    const auto tile =
        std::make_shared<RoamTile>(PlacedTile(testsupport::hills(100, 90, 30.0), Placement::planar));
    TileEditor editor(tile);
    const PreparedDecimation prepared(tile);
    const auto mesh = prepared.newMesh();
    testsupport::Random random(3);
    for (int frame = 0; frame < 60; ++frame)
    {
        const GridPoint place{static_cast<int>(random.below(100)), static_cast<int>(random.below(90))};
        const HeightChange change{place, static_cast<float>(300.0 + 400.0 * random.unit())};
        ASSERT_TRUE(editor.apply({&change, 1}, TileEditor::Between::follows));
        EXPECT_TRUE(mesh->isBehind());
        const auto view = viewAt(*tile, frame);
        mesh->setMorphing(frame % 2 == 1);
        mesh->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_FALSE(mesh->isBehind());
        ASSERT_TRUE(isSound(*mesh, view, 2.0)) << frame;
        if (frame % 20 != 19) continue;
        const auto anew = PreparedDecimation(tile).newMesh(), late = prepared.newMesh();
        for (TerrainMesh* other : {anew.get(), late.get()})
        {
            other->setMorphing(frame % 2 == 1);
            other->refine(view, {.errorTolerancePx = 2.0});
            ASSERT_EQ(pictured(*other), pictured(*mesh)) << frame;
        }
    }
}

TEST(DecimatedChanges, OmitsNoBlockThatIsSeen)
{
    const auto tile = ruggedTile();
    const auto mesh = PreparedDecimation(tile).newMesh();
    std::size_t omitted = 0;
    for (int frame = 0; frame < 240; frame += 10)
    {
        const auto view = viewAt(*tile, frame);
        mesh->refine(view, {.errorTolerancePx = 2.0});
        std::vector<IndexRange> ranges;
        const std::uint32_t triangles = mesh->visibleRanges(view.frustum, view.eyeWorld, nullptr, ranges);
        const DrawnMesh part = mesh->drawn(ranges);
        ASSERT_EQ(part.triangles.size(), triangles);
        omitted += mesh->drawn().triangles.size() - triangles;
        std::set<std::pair<int, int>> seen;
        for (const LeafTriangle& t : part.triangles)
            for (const std::uint32_t v : t.vertices)
                seen.emplace(part.grid[v].column, part.grid[v].row);
        const DrawnMesh whole = mesh->drawn();
        for (const LeafTriangle& t : whole.triangles)
            for (const std::uint32_t v : t.vertices)
            {
                const auto pixel = viewlod::projectPx(view, whole.position(v));
                const bool isSeen = pixel && pixel->x >= 0 && pixel->y >= 0 && pixel->x <= view.widthPx &&
                                    pixel->y <= view.heightPx;
                ASSERT_TRUE(!isSeen || seen.contains({whole.grid[v].column, whole.grid[v].row}));
            }
    }
    EXPECT_GT(omitted, 10000u);
}

TEST(DecimatedChanges, KnowsTheNearestOfItsSurface)
{
    const auto tile = ruggedTile(70, 70);
    const auto mesh = PreparedDecimation(tile).newMesh();
    mesh->refine(20.0);
    const glm::dvec3 vertex = mesh->drawn().position(mesh->drawn().triangles[17].vertices[1]);
    EXPECT_NEAR(mesh->nearestM(vertex), 0.0, 1e-6);
    EXPECT_NEAR(mesh->nearestM({100.0, 100.0, 5000.0}), 5000.0 - 700.0, 600.0);
}

} // namespace
