// SPDX-License-Identifier: Apache-2.0
// Meshes of a tile that is edited between their frames.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"

namespace
{

using namespace osgTerrainROAM::core;
using Between = TileEditor::Between;

/// A view from an eye that moves over the tile.
viewlod::ViewState viewAt(const PlacedTile& tile, int frame)
{
    const double t = 0.02 * frame, half = 0.5 * (tile.grid().dataColumns() - 1);
    const auto place = [&](double ahead, double heightM)
    {
        return tile.frame().positionAt(half * (1.0 + 0.6 * std::sin(t + ahead)),
                                       half * (1.0 + 0.6 * std::cos(0.7 * t + ahead)), heightM);
    };
    return viewlod::ViewState::fromMatrices(
        glm::lookAt(place(0.0, 900.0), place(0.6, 300.0), {0.01, 0.02, 1.0}),
        glm::perspective(1.0, 1.25, 1.0, 1e5), 1280, 1024);
}

/// A small brush at a random position: samples of the raster or, on a finer grid, points between them.
std::vector<HeightChange> brush(const PlacedTile& tile, testsupport::Random& random, Between between)
{
    const int step = between == Between::follows ? tile.grid().cellSide() : 1;
    const int columns = (tile.grid().dataColumns() - 1) / step, rows = (tile.grid().dataRows() - 1) / step;
    const int width = 1 + static_cast<int>(random.below(5)), height = 1 + static_cast<int>(random.below(5));
    const int west = static_cast<int>(random.below(static_cast<std::uint32_t>(columns)));
    const int south = static_cast<int>(random.below(static_cast<std::uint32_t>(rows)));
    std::vector<HeightChange> changes;
    for (int row = south; row <= std::min(south + height, rows); ++row)
        for (int column = west; column <= std::min(west + width, columns); ++column)
            changes.push_back({{column * step, row * step},
                               tile.samples().heightM(column * step, row * step) +
                                   static_cast<float>(40.0 * random.unit() - 20.0)});
    return changes;
}

struct Case
{
    bool curved;
    int gridExponent;
    int patchExponent;
    Driver driver;
    bool morphs;
};

class EditedMesh : public testing::TestWithParam<Case>
{
protected:
    EditedMesh()
    {
        HeightField field = testsupport::hills(60, 65);
        if (GetParam().curved) field = testsupport::onTheEarth(std::move(field));
        tile = std::make_shared<RoamTile>(PlacedTile(
            std::move(field), {.placement = GetParam().curved ? Placement::curved : Placement::planar,
                               .gridExponent = GetParam().gridExponent}));
    }

    std::shared_ptr<RoamTile> tile;
};

TEST_P(EditedMesh, IsTheSameAsOneMadeAnewAndKeepsItsBound)
{
    TileEditor editor(tile);
    RoamMesh mesh(SplitBounds(tile, GetParam().patchExponent), GetParam().driver);
    mesh.setMorphing(GetParam().morphs);
    testsupport::Random random(17);
    const bool between = GetParam().gridExponent > 0;
    for (int frame = 0; frame < 100; ++frame)
    {
        for (std::uint32_t i = 0; i < random.below(4); ++i)
        {
            const Between kind = between && random.below(3) > 0 ? Between::stays : Between::follows;
            ASSERT_TRUE(editor.apply(brush(tile->tile, random, kind), kind));
        }
        if (frame % 10 == 7) editor.undo();
        if (frame % 25 == 11) editor.tighten(4000);
        const viewlod::ViewState view = viewAt(tile->tile, frame);
        mesh.refine(view, {.errorTolerancePx = 2.0});
        ASSERT_FALSE(mesh.isBehind());
        ASSERT_TRUE(mesh.isConforming()) << frame;
        const DrawnMesh drawn = mesh.drawn();
        const DrawnMeshReport report = checkDrawnMesh(*tile, drawn, &view);
        ASSERT_EQ(report.tJunctions, 0u) << frame;
        ASSERT_EQ(report.cracks, 0u) << frame;
        ASSERT_LE(report.maxErrorPx, 2.0) << frame;
        if (frame % 10 != 9) continue;
        RoamMesh anew(SplitBounds(tile, GetParam().patchExponent), GetParam().driver);
        anew.setMorphing(GetParam().morphs);
        anew.refine(view, {.errorTolerancePx = 2.0});
        ASSERT_EQ(mesh.tree().leafCount(), anew.tree().leafCount()) << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Cases, EditedMesh,
    testing::Values(Case{false, 0, 0, Driver::wheel, false}, Case{true, 0, 0, Driver::wheel, false},
                    Case{false, 3, 0, Driver::wheel, false}, Case{true, 4, 0, Driver::wheel, false},
                    Case{false, 0, 4, Driver::wheel, false}, Case{false, 0, 0, Driver::walk, false},
                    Case{true, 2, 0, Driver::queue, false}, Case{true, 3, 0, Driver::wheel, true}));

/// A hundred thousand edits in all; the mesh stays valid.
class Shards : public testing::TestWithParam<int>
{
};

TEST_P(Shards, OfAHundredThousandEditsLeaveASoundMesh)
{
    const auto tile = std::make_shared<RoamTile>(
        PlacedTile(testsupport::hills(129, 120), {.placement = Placement::planar, .gridExponent = 2}));
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)};
    testsupport::Random random(static_cast<std::uint64_t>(41 + GetParam()));
    for (int frame = 0; frame < 125; ++frame)
    {
        for (int i = 0; i < 200; ++i)
        {
            const GridPoint p{static_cast<int>(random.below(513)), static_cast<int>(random.below(477))};
            const bool ofRaster = random.below(2) == 0;
            const GridPoint place = ofRaster ? GridPoint{p.column & -4, p.row & -4} : p;
            const float heightM = tile->tile.samples().heightM(place.column, place.row) +
                                  static_cast<float>(6.0 * random.unit() - 3.0);
            ASSERT_TRUE(editor.apply(std::vector<HeightChange>{{place, heightM}},
                                     ofRaster ? Between::follows : Between::stays));
            if (random.below(50) == 0) editor.undo();
        }
        if (frame % 40 == 39) editor.forgetUndo();
        const viewlod::ViewState view = viewAt(tile->tile, frame);
        mesh.refine(view, {.errorTolerancePx = 3.0});
        if (frame % 25 != 24) continue;
        ASSERT_TRUE(mesh.isConforming()) << frame;
        const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), &view);
        ASSERT_EQ(report.tJunctions + report.cracks, 0u) << frame;
        ASSERT_LE(report.maxErrorPx, 3.0) << frame;
    }
}

INSTANTIATE_TEST_SUITE_P(Edits, Shards, testing::Range(0, 4));

/// A copy of the mesh, as on a graphics card, that receives the changes only.
TEST(FollowingMesh, TellsWhatToUpload)
{
    const auto tile = std::make_shared<RoamTile>(PlacedTile(testsupport::hills(65, 65), Placement::planar));
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)};
    testsupport::Random random(23);
    std::vector<MeshVertex> vertices;
    const viewlod::ViewState view = viewAt(tile->tile, 5);
    mesh.refine(view, {.errorTolerancePx = 1.0});
    for (VertexSlot v = 0; v < mesh.vertexSlots(); ++v)
        vertices.push_back(mesh.vertex(v));
    for (int frame = 0; frame < 40; ++frame)
    {
        ASSERT_TRUE(editor.apply(brush(tile->tile, random, Between::follows), Between::follows));
        mesh.refine(view, {.errorTolerancePx = 1.0});
        vertices.resize(mesh.vertexSlots());
        for (const std::uint32_t v : mesh.changes().vertices)
            vertices[v] = mesh.vertex(v);
        for (VertexSlot v = 0; v < mesh.vertexSlots(); ++v)
        {
            if (mesh.tree().place(v).isFree()) continue;
            ASSERT_EQ(vertices[v], mesh.vertex(v)) << frame;
        }
    }
}

TEST(FollowingMesh, StartsOverWhenTheEditsAreForgotten)
{
    const auto tile = std::make_shared<RoamTile>(PlacedTile(testsupport::hills(65, 65), Placement::planar));
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)}, steady{SplitBounds(tile)};
    const viewlod::ViewState view = viewAt(tile->tile, 5);
    mesh.refine(view, {.errorTolerancePx = 1.0});
    testsupport::Random random(29);
    for (int i = 0; i < 40; ++i)
    {
        std::vector<HeightChange> all;
        for (int row = 0; row < 65; ++row)
            for (int column = 0; column < 65; ++column)
                all.push_back({{column, row}, static_cast<float>(300.0 * random.unit())});
        ASSERT_TRUE(editor.apply(all, Between::follows));
        editor.forgetUndo();
        tile->note({std::vector<GridPoint>(1 << 16), {}});
    }
    EXPECT_FALSE(tile->changesSince(0));
    mesh.refine(view, {.errorTolerancePx = 1.0});
    steady.refine(view, {.errorTolerancePx = 1.0});
    EXPECT_EQ(mesh.tree().leafCount(), steady.tree().leafCount());
    EXPECT_LE(checkDrawnMesh(*tile, mesh.drawn(), &view).maxErrorPx, 1.0);
}

} // namespace
