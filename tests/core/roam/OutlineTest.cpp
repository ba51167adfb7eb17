// SPDX-License-Identifier: Apache-2.0
// Data of any outline, holes included: what is drawn ends where they end, at every level of detail, to the
// tolerance.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/ErrorTree.h>
#include <osgTerrainROAM/core/roam/GroundRay.h>
#include <osgTerrainROAM/core/roam/Outline.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "SoundMesh.h"
#include "TreeWalks.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::isSoundFrom;
using testsupport::Random;

/// Hills with a bay in the north-east, a round lake, and single samples missing.
HeightField holedHills(int columns, int rows, std::uint64_t seed)
{
    HeightField field = testsupport::hills(columns, rows, 30.0, seed);
    Random random(seed);
    std::vector<std::uint8_t> isThere(field.heightsM.size(), 1);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
        {
            const bool isBay = column > columns / 2 && row > rows - 7 - column % 9;
            const bool isLake = std::hypot(column - columns / 3.0, row - rows / 3.0) < 0.16 * rows;
            if (isBay || isLake || random.below(300) == 0)
                isThere[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                        static_cast<std::size_t>(column)] = 0;
        }
    field.mask = SampleMask(isThere, columns, rows);
    return field;
}

viewlod::ViewState viewDown(const PlacedTile& tile, Random& random)
{
    const glm::dvec3 last = tile.position(tile.grid().dataColumns() - 1, tile.grid().dataRows() - 1);
    const glm::dvec3 eye(random.unit() * last.x, random.unit() * last.y, 600.0 + 900.0 * random.unit());
    const glm::dvec3 target(random.unit() * last.x, random.unit() * last.y, 300.0);
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, target, {0.0, 0.02, 1.0}),
                                            glm::perspective(1.0, 1.3, 1.0, 1e5), 800, 600);
}

struct Shape
{
    int columns, rows;
    int gridExponent = 0;
    bool isCurved = false;
};

class Outline : public testing::TestWithParam<Shape>
{
protected:
    static std::shared_ptr<RoamTile> tileOf(const Shape& shape, std::uint64_t seed = 3)
    {
        HeightField field = holedHills(shape.columns, shape.rows, seed);
        if (shape.isCurved) field = testsupport::onTheEarth(std::move(field));
        return std::make_shared<RoamTile>(
            PlacedTile(std::move(field), {.placement = shape.isCurved ? Placement::curved : Placement::planar,
                                          .gridExponent = shape.gridExponent}));
    }
};

TEST_P(Outline, IsWithinTheToleranceFromAnyEye)
{
    const auto tile = tileOf(GetParam());
    RoamMesh mesh{SplitBounds(tile)};
    Random random(11);
    for (int i = 0; i < 40; ++i)
    {
        const viewlod::ViewState view = viewDown(tile->tile, random);
        const double tolerancePx = 0.5 + 6.0 * random.unit();
        ASSERT_TRUE(isSoundFrom(mesh, view, tolerancePx)) << i;
    }
}

TEST_P(Outline, IsTheDataAtFullDetail)
{
    const auto tile = tileOf(GetParam());
    const PlacedTile& placed = tile->tile;
    RoamMesh mesh{SplitBounds(tile)};
    mesh.refine(0.0);
    std::size_t wanted = 0;
    const int step = placed.grid().cellSide();
    for (int row = 0; row + step < placed.grid().dataRows(); row += step)
        for (int column = 0; column + step < placed.grid().dataColumns(); column += step)
        {
            const GridPoint sw{column, row}, se{column + step, row}, nw{column, row + step},
                ne{column + step, row + step};
            const bool isEven = ((column + row) / step) % 2 == 0;
            const GridPoint halves[2][3] = {{sw, se, isEven ? ne : nw}, {ne, nw, isEven ? sw : se}};
            for (const auto& half : halves)
                wanted += std::all_of(
                    half, half + 3, [&](GridPoint p) { return placed.samples().isGround(p.column, p.row); });
        }
    const DrawnMesh drawn = mesh.drawn();
    // Flat pieces stay coarse, so areas are compared, in halves of cells.
    std::size_t found = 0;
    for (const LeafTriangle& t : drawn.triangles)
    {
        const GridPoint a = drawn.grid[t.vertices[0]], b = drawn.grid[t.vertices[1]],
                        c = drawn.grid[t.vertices[2]];
        ASSERT_TRUE(isDrawn(placed, {a, b, c}));
        const auto clamped = [&](GridPoint p)
        {
            return GridPoint{std::min(p.column, placed.grid().dataColumns() - 1),
                             std::min(p.row, placed.grid().dataRows() - 1)};
        };
        if (!(clamped(a) == a && clamped(b) == b && clamped(c) == c)) continue;
        found += static_cast<std::size_t>((b.column - a.column) * (c.row - a.row) -
                                          (b.row - a.row) * (c.column - a.column)) /
                 static_cast<std::size_t>(step * step);
    }
    EXPECT_EQ(found, wanted);
}

TEST_P(Outline, SurvivesRandomSplitsAndMerges)
{
    const auto tile = tileOf(GetParam(), 5);
    DiamondTree tree{SplitBounds(tile)};
    Random random(21);
    for (int i = 0; i < 6000; ++i)
    {
        if (random.below(5) < 4)
        {
            const TriangleId t = testsupport::randomDescent(tree, random);
            if (tree.canSplit(t)) tree.forceSplit(t);
        }
        else if (const VertexSlot v = testsupport::randomVertex(tree, random, 6); v != kNone)
        {
            if (random.below(2) == 0)
                tree.enhMerge(v);
            else
                tree.forceMerge(v);
        }
        ASSERT_TRUE(i % 50 != 0 || tree.isConforming()) << i;
    }
    ASSERT_TRUE(tree.isConforming());
}

TEST_P(Outline, IsTheSameForAllDriversAndFromScratch)
{
    const auto tile = tileOf(GetParam());
    Random random(31);
    std::vector<std::unique_ptr<RoamMesh>> meshes;
    for (const Driver driver : {Driver::wheel, Driver::walk, Driver::queue})
    {
        meshes.push_back(std::make_unique<RoamMesh>(SplitBounds(tile)));
        meshes.back()->setDriver(driver);
    }
    for (int i = 0; i < 20; ++i)
    {
        const viewlod::ViewState view = viewDown(tile->tile, random);
        for (const auto& mesh : meshes)
            mesh->refine(view, {.errorTolerancePx = 2.0});
        for (const auto& mesh : meshes)
            ASSERT_EQ(testsupport::leafSet(mesh->tree()), testsupport::leafSet(meshes.front()->tree())) << i;
    }
}

TEST_P(Outline, EndsQueriesAndRays)
{
    const auto tile = tileOf(GetParam());
    const PlacedTile& placed = tile->tile;
    RoamMesh mesh{SplitBounds(tile)};
    mesh.refine(0.0);
    Random random(41);
    int inHoles = 0, onGround = 0;
    for (int i = 0; i < 4000; ++i)
    {
        const double column = random.unit() * (placed.grid().dataColumns() - 1),
                     row = random.unit() * (placed.grid().dataRows() - 1);
        const glm::dvec3 p = placed.frame().positionAt(column, row, 400.0);
        const auto truth = groundAt(placed, p.x, p.y);
        const auto drawn = drawnGroundAt(mesh.tree(), p.x, p.y);
        const auto ray = hitGround(*tile, p + glm::dvec3(0.0, 0.0, 5000.0), {0.0, 0.0, -1.0}, 1e5);
        ASSERT_EQ(truth.has_value(), drawn.has_value()) << column << ", " << row;
        ASSERT_EQ(truth.has_value(), ray.has_value()) << column << ", " << row;
        ASSERT_NEAR(truth ? truth->position.z : 0.0, ray ? ray->position.z : 0.0, 1e-3);
        ++(truth ? onGround : inHoles);
    }
    EXPECT_GT(inHoles, 100);
    EXPECT_GT(onGround, 2000);
}

TEST_P(Outline, HoldsAfterEdits)
{
    const auto tile = tileOf(GetParam());
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)};
    Random random(51);
    const int step = tile->tile.grid().cellSide();
    for (int i = 0; i < 60; ++i)
    {
        const GridPoint p{static_cast<int>(random.below(static_cast<std::uint32_t>(GetParam().columns))) *
                              step,
                          static_cast<int>(random.below(static_cast<std::uint32_t>(GetParam().rows))) * step};
        const HeightChange change{p, 300.0f + 400.0f * static_cast<float>(random.unit())};
        ASSERT_EQ(static_cast<bool>(editor.apply({&change, 1}, TileEditor::Between::follows)),
                  tile->tile.samples().isGround(p.column, p.row));
        const viewlod::ViewState view = viewDown(tile->tile, random);
        ASSERT_TRUE(isSoundFrom(mesh, view, 2.0)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Outline, testing::Values(Shape{65, 65}, Shape{90, 70}, Shape{70, 90, 0, true}, Shape{50, 60, 2}),
    [](const auto& given)
    {
        return std::to_string(given.param.columns) + "x" + std::to_string(given.param.rows) +
               (given.param.isCurved ? "curved" : "") + (given.param.gridExponent ? "fine" : "");
    });

TEST(OutlineError, IsWhatTheCheckWouldMiss)
{
    // The same data with their holes filled have a coarser mesh; drawn with the holes, its outline is off.
    const auto tile = std::make_shared<RoamTile>(PlacedTile(holedHills(129, 129, 3), Placement::planar));
    HeightField filled = holedHills(129, 129, 3);
    filled.mask = {};
    const auto blind = std::make_shared<RoamTile>(PlacedTile(std::move(filled), Placement::planar));
    const viewlod::ViewState view = viewlod::ViewState::fromMatrices(
        glm::lookAt(glm::dvec3(1900.0, 1900.0, 5000.0), {1900.0, 1900.0, 0.0}, {0.0, 1.0, 0.0}),
        glm::perspective(1.0, 1.3, 1.0, 1e5), 800, 600);
    RoamMesh mesh{SplitBounds(blind)};
    mesh.refine(view, {.errorTolerancePx = 20.0});
    EXPECT_GT(checkDrawnMesh(*tile, mesh.drawn(), &view).maxErrorPx, 20.0);
}

TEST(OutlineCheck, SeesATJunctionBesideAHole)
{
    const auto tile = std::make_shared<RoamTile>(PlacedTile(holedHills(65, 65, 3), Placement::planar));
    RoamMesh mesh{SplitBounds(tile)};
    mesh.refine(30.0);
    DrawnMesh drawn = mesh.drawn();
    ASSERT_EQ(checkDrawnMesh(*tile, drawn, nullptr).tJunctions, 0u);
    // One half of a diamond is split, the other not: the middle of the base becomes a T-junction.
    for (std::size_t i = 0; i < drawn.triangles.size(); ++i)
    {
        const auto at = [&](int k) { return drawn.grid[drawn.triangles[i].vertices[k]]; };
        const GridTriangle t{at(0), at(1), at(2)};
        const GridPoint mid = t.middleOfBase();
        const bool isInside = mid.column > 0 && mid.row > 0 && mid.column < 64 && mid.row < 64;
        if (!isInside || (t.left.column + t.right.column) % 2 || (t.left.row + t.right.row) % 2) continue;
        const auto m = static_cast<std::uint32_t>(drawn.vertices.size());
        DrawnMesh split = drawn;
        split.vertices.push_back(drawn.vertices[drawn.triangles[i].vertices[0]]);
        split.grid.push_back(mid);
        const LeafTriangle whole = drawn.triangles[i];
        split.triangles[i] = {{m, whole.vertices[0], whole.vertices[1]}};
        split.triangles.push_back({{m, whole.vertices[2], whole.vertices[0]}});
        const GridPoint across{2 * mid.column - t.apex.column, 2 * mid.row - t.apex.row};
        if (!tile->tile.samples().isGround(across.column, across.row)) continue;
        EXPECT_GT(checkDrawnMesh(*tile, split, nullptr).tJunctions, 0u);
        return;
    }
    FAIL() << "no triangle to split";
}

} // namespace
