// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <set>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/roam/TriangleSamples.h>

#include "DecimatedFlight.h"
#include "SyntheticField.h"
#include "measurement/flights/BenchmarkFlight.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using testsupport::isSound;
using testsupport::pictured;

std::shared_ptr<const RoamTile> hills(int columns = 129, int rows = 129)
{
    return testsupport::planarTile(testsupport::hills(columns, rows, 90.0));
}

viewlod::ViewState viewAt(const RoamTile& tile, double frame)
{
    auto view = BenchmarkFlight{}.view(tile.tile, static_cast<int>(frame));
    view.eyeWorld += glm::dvec3(36.0, 27.0, 0.0) * (frame - std::floor(frame));
    return view;
}

TEST(DecimatedMesh, DrawsRastersOfAnySize)
{
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 17}, {33, 33}, {34, 33}, {65, 40}, {100, 129}})
        for (const bool morphs : {false, true})
        {
            const auto tile = hills(columns, rows);
            const auto mesh = PreparedDecimation(tile).newMesh();
            mesh->setMorphing(morphs);
            const auto view = viewAt(*tile, 0);
            mesh->refine(view, {.errorTolerancePx = 3.0});
            EXPECT_TRUE(isSound(*mesh, view, 3.0)) << columns << 'x' << rows;
            for (const double errorM : {1e9, 40.0, 4.0, 0.0})
            {
                mesh->refine(errorM);
                const auto report = checkDrawnMesh(*tile, mesh->drawn(), nullptr);
                EXPECT_EQ(report.tJunctions + report.cracks, 0u) << columns << 'x' << rows << ' ' << errorM;
            }
        }
}

TEST(DecimatedMesh, KeepsTheBoundOnTheRoundEarthToo)
{
    const auto tile = std::make_shared<const RoamTile>(
        PlacedTile(testsupport::onTheEarth(testsupport::hills(200, 150, 90.0)), Placement::curved));
    const auto mesh = PreparedDecimation(tile).newMesh();
    for (int frame = 0; frame < 240; frame += 8)
    {
        mesh->setMorphing(frame % 16 == 0);
        const auto view = viewAt(*tile, frame);
        mesh->refine(view, {.errorTolerancePx = 1.0});
        ASSERT_TRUE(isSound(*mesh, view, 1.0)) << frame;
    }
}

TEST(DecimatedMesh, NeighboursOfAnyLevelsMeet)
{
    // A plain with one rough block: its neighbours are two triangles each.
    HeightField field = testsupport::hills(161, 161, 30.0);
    for (int row = 0; row < 161; ++row)
        for (int column = 0; column < 161; ++column)
            if (column <= 64 || column >= 96 || row <= 64 || row >= 96)
                field.heightsM[static_cast<std::size_t>(row * 161 + column)] = 400.0f;
    const auto tile = testsupport::planarTile(std::move(field));
    const auto prepared = PreparedDecimation(tile);
    DecimatedMesh mesh(prepared.errors());
    mesh.refine(0.5);
    const std::uint32_t rough = mesh.errors().grid().blockAt(2, 2);
    EXPECT_EQ(mesh.levels()[rough], 0.0);
    EXPECT_EQ(mesh.levels()[mesh.errors().grid().blockAt(1, 2)], 5.0);
    const auto report = checkDrawnMesh(*tile, mesh.drawn(), nullptr);
    EXPECT_EQ(report.tJunctions + report.cracks, 0u);
}

/// Draws blocks of given shapes.
DrawnMesh drawnBlocks(const RoamTile& tile, const BlockGrid& grid, const std::vector<BlockShape>& shapes)
{
    DrawnMesh mesh;
    mesh.stepM = tile.tile.frame().vertexStepM();
    for (std::uint32_t block = 0; block < grid.count(); ++block)
        for (const BlockTriangle& t : trianglesOf(grid.exponent(), shapes[block], grid.origin(block)))
        {
            const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
            for (const GridPoint local : t)
            {
                const GridPoint p{grid.origin(block).column + local.column,
                                  grid.origin(block).row + local.row};
                mesh.grid.push_back(p);
                mesh.vertices.push_back(meshVertex(tile.tile.position(p.column, p.row), p, mesh.stepM));
            }
            mesh.triangles.push_back({{first, first + 1, first + 2}});
        }
    return mesh;
}

TEST(DecimatedMesh, WithoutFansTheCheckFindsTJunctions)
{
    const auto tile = hills();
    const auto errors = PreparedDecimation(tile).errors();
    const BlockGrid& grid = errors->grid();
    const BlockLevels levels = chooseLevels(*errors, AllowedErrors(*errors, viewAt(*tile, 10)), 4.0);
    std::vector<BlockShape> right, wrong;
    for (std::uint32_t block = 0; block < grid.count(); ++block)
    {
        right.push_back(shapeAt(grid, levels, block));
        wrong.push_back(right.back());
        wrong.back().borders.fill(wrong.back().level);
    }
    EXPECT_EQ(checkDrawnMesh(*tile, drawnBlocks(*tile, grid, right), nullptr).tJunctions, 0u);
    EXPECT_GT(checkDrawnMesh(*tile, drawnBlocks(*tile, grid, wrong), nullptr).tJunctions, 0u);
}

/// The drawn place of every sample.
std::vector<glm::dvec3> drawnSamples(const TerrainMesh& mesh)
{
    const PlacedTile& tile = mesh.tile().tile;
    const int columns = tile.grid().dataColumns();
    std::vector<glm::dvec3> places(static_cast<std::size_t>(columns * tile.grid().dataRows()));
    const DrawnMesh drawn = mesh.drawn();
    for (const LeafTriangle& t : drawn.triangles)
    {
        const PlanTriangle plan{
            {drawn.grid[t.vertices[0]], drawn.grid[t.vertices[1]], drawn.grid[t.vertices[2]]}};
        const glm::dvec3 a = drawn.position(t.vertices[0]), du = drawn.position(t.vertices[1]) - a,
                         dw = drawn.position(t.vertices[2]) - a;
        forEachSampleIn(tile, plan,
                        [&](GridPoint p)
                        {
                            const auto b = plan.at(p.column, p.row);
                            places[static_cast<std::size_t>(p.row * columns + p.column)] =
                                a + du * b.u + dw * b.w;
                        });
    }
    return places;
}

/// The largest distance of a sample from the mesh that is refined to an error.
double largestErrorM(const std::shared_ptr<const BlockErrors>& errors, double errorM)
{
    DecimatedMesh mesh(errors);
    mesh.refine(errorM);
    const PlacedTile& tile = errors->tile().tile;
    const std::vector<glm::dvec3> drawn = drawnSamples(mesh);
    double largestM = 0.0;
    for (std::size_t i = 0; i < drawn.size(); ++i)
    {
        const int column = static_cast<int>(i) % tile.grid().dataColumns(),
                  row = static_cast<int>(i) / tile.grid().dataColumns();
        largestM = std::max(largestM, glm::distance(drawn[i], tile.position(column, row)));
    }
    return largestM;
}

TEST(DecimatedMesh, ErrorsInMetresAreKeptAndSmallerOnesAreFound)
{
    const auto right = PreparedDecimation(hills()).errors();
    const auto smaller = std::make_shared<BlockErrors>(*right);
    BlockErrorsMutation::scale(*smaller, 0.8f);
    int smallerFound = 0;
    double nearest = 0.0;
    for (double errorM = 2.0; errorM < 200.0; errorM *= 1.1)
    {
        const double foundM = largestErrorM(right, errorM);
        ASSERT_LE(foundM, errorM);
        nearest = std::max(nearest, foundM / errorM);
        if (largestErrorM(smaller, errorM) > errorM) ++smallerFound;
    }
    EXPECT_GT(nearest, 0.99) << "the bound is not exact";
    EXPECT_GT(smallerFound, 5);
}

TEST(DecimatedMesh, ErrorsOfFansCount)
{
    // A plain, and beside it waves that grow with the distance from it: the fans are off by more than the block.
    HeightField field = testsupport::hills(65, 65, 30.0);
    for (int row = 0; row < 65; ++row)
        for (int column = 0; column < 65; ++column)
            field.heightsM[static_cast<std::size_t>(row * 65 + column)] =
                static_cast<float>(10.0 * std::max(row - 32, 0) * std::sin(column * 0.2));
    const auto right = PreparedDecimation(testsupport::planarTile(std::move(field), Storage::exact)).errors();
    const auto blind = std::make_shared<BlockErrors>(*right);
    BlockErrorsMutation::forgetStrips(*blind);
    int found = 0;
    for (double errorM = 1.0; errorM < 100.0; errorM *= 1.1)
    {
        ASSERT_LE(largestErrorM(right, errorM), errorM);
        if (largestErrorM(blind, errorM) > errorM) ++found;
    }
    EXPECT_GT(found, 0);
}

/// The frames of a flight that are off by more than allowed.
int framesBeyond(const std::shared_ptr<const RoamTile>& tile, std::shared_ptr<const BlockErrors> errors,
                 bool morphs)
{
    DecimatedMesh mesh(std::move(errors));
    mesh.setMorphing(morphs);
    int beyond = 0;
    for (int frame = 0; frame < 240; frame += 12)
    {
        const auto view = viewAt(*tile, frame);
        mesh.refine(view, {.errorTolerancePx = 2.0});
        if (!isSound(mesh, view, 2.0)) ++beyond;
    }
    return beyond;
}

TEST(DecimatedMesh, ErrorsThatAreFarTooSmallAreFoundInPixels)
{
    const auto tile = hills();
    const auto right = PreparedDecimation(tile).errors();
    const auto wrong = std::make_shared<BlockErrors>(*right);
    BlockErrorsMutation::scale(*wrong, 0.2f);
    for (const bool morphs : {false, true})
    {
        EXPECT_EQ(framesBeyond(tile, right, morphs), 0);
        EXPECT_GT(framesBeyond(tile, wrong, morphs), 0);
    }
}

TEST(DecimatedMesh, IsAFunctionOfTheEye)
{
    const auto tile = hills();
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

TEST(DecimatedMesh, TheChangesLeadFromMeshToMesh)
{
    const auto tile = hills();
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

TEST(DecimatedMesh, TheCeilingRaisesTheTolerance)
{
    const auto tile = hills();
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
    const auto tile = hills();
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

TEST(DecimatedMesh, MorphingLeavesNoJumps)
{
    const double with = largestJumpPx(true), without = largestJumpPx(false);
    EXPECT_GT(without, 0.5) << "nothing ever jumps: nothing was checked";
    EXPECT_LT(with, 0.1 * without);
    std::cout << "largest jump of the drawn ground: " << with << " px with morphing, " << without
              << " px without\n";
}

TEST(DecimatedMesh, FollowsEdits)
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

TEST(DecimatedMesh, OmitsNoBlockThatIsSeen)
{
    const auto tile = hills();
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

TEST(DecimatedMesh, KnowsTheNearestOfItsSurface)
{
    const auto tile = hills(70, 70);
    const auto mesh = PreparedDecimation(tile).newMesh();
    mesh->refine(20.0);
    const glm::dvec3 vertex = mesh->drawn().position(mesh->drawn().triangles[17].vertices[1]);
    EXPECT_NEAR(mesh->nearestM(vertex), 0.0, 1e-6);
    EXPECT_NEAR(mesh->nearestM({100.0, 100.0, 5000.0}), 5000.0 - 700.0, 600.0);
}

} // namespace
