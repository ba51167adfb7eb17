// SPDX-License-Identifier: Apache-2.0
// Tiles with denser parts: one mesh over all of them, within the tolerance of every sample, on both sides of
// their borders.
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SoundMesh.h"
#include "TreeWalks.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::isSoundFrom;
using testsupport::Random;

double detailM(double column, double row)
{
    return 500.0 + 90.0 * std::sin(0.4 * column) * std::cos(0.3 * row) +
           6.0 * std::sin(7.0 * column + 5.0 * row);
}

/// A part of that ground, in samples of the field; raised.
DensePart partOf(int west, int south, int columns, int rows, int exponent, double raisedM)
{
    DensePart part{west, south, columns, rows, exponent, {}};
    const int cell = 1 << exponent;
    for (int r = 0; r <= rows * cell; ++r)
        for (int c = 0; c <= columns * cell; ++c)
            part.heightsM.push_back(
                static_cast<float>(raisedM + detailM(west + static_cast<double>(c) / cell,
                                                     south + static_cast<double>(r) / cell)));
    return part;
}

/// Two parts that overlap, one of them in a corner of the data.
HeightField field(int columns, int rows)
{
    HeightField field = testsupport::hills(columns, rows);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            field.heightsM[static_cast<std::size_t>(row * columns + column)] =
                static_cast<float>(detailM(column, row));
    field.parts.push_back(partOf(5, 6, 12, 9, 2, 3.0));
    field.parts.push_back(partOf(0, 0, 7, 8, 4, 5.0));
    return field;
}

class Sheets : public testing::TestWithParam<bool>
{
protected:
    Sheets()
    {
        HeightField made = field(40, 33);
        if (GetParam()) made = testsupport::onTheEarth(std::move(made));
        tile = std::make_shared<RoamTile>(
            PlacedTile(std::move(made), GetParam() ? Placement::curved : Placement::planar));
    }

    viewlod::ViewState randomView(Random& random) const
    {
        const PlacedTile& placed = tile->tile;
        const auto place = [&](double reach, double heightM)
        { return placed.frame().positionAt(random.unit() * reach, random.unit() * reach, heightM); };
        const double last = placed.grid().dataRows() - 1.0;
        return viewlod::ViewState::fromMatrices(glm::lookAt(place(last, 620.0 + 300.0 * random.unit()),
                                                            place(0.5 * last, 450.0), {0.0, 0.02, 1.0}),
                                                glm::perspective(1.0, 1.3, 1.0, 1e5), 800, 600);
    }

    std::shared_ptr<RoamTile> tile;
};

TEST_P(Sheets, HoldTheirSamplesInsideAndTheGroundBelowAtTheirBorders)
{
    const PlacedTile& placed = tile->tile;
    ASSERT_EQ(placed.grid().exponent(), 4);
    ASSERT_EQ(placed.samples().sheets().size(), 2u);
    const auto at = [&](double column, double row)
    { return placed.samples().heightM(static_cast<int>(column * 16), static_cast<int>(row * 16)); };
    EXPECT_NEAR(at(12.25, 10.5), 3.0 + detailM(12.25, 10.5), 0.01); // of the first, far inside
    EXPECT_NEAR(at(12.0, 10.0), 3.0 + detailM(12.0, 10.0), 0.01);   // where the raster has a sample, too
    EXPECT_NEAR(at(3.0625, 3.125), 5.0 + detailM(3.0625, 3.125), 0.01);
    EXPECT_NEAR(at(6.0 - 1.0 / 16, 6.5), at(6.0 - 1.0 / 16, 6.5), 0.0);
    EXPECT_NEAR(at(30.0, 20.0), detailM(30.0, 20.0), 0.01);
    for (const double row : {7.0, 9.5, 11.25, 14.0}) // the eastern border of the first
    {
        const double south = std::floor(row), t = row - south;
        EXPECT_NEAR(at(17.0, row), std::lerp(at(17.0, south), at(17.0, south + (t > 0.0 ? 1.0 : 0.0)), t),
                    0.01)
            << row;
        EXPECT_NEAR(at(17.0, row), at(17.0 - 1.0 / 16, row), 4.0) << row; // no step
    }
}

TEST_P(Sheets, AreDrawnWithinTheToleranceFromAnyEye)
{
    RoamMesh mesh{SplitBounds(tile)};
    Random random(7);
    for (int i = 0; i < 30; ++i)
    {
        const viewlod::ViewState view = randomView(random);
        const double tolerancePx = 0.4 + 4.0 * random.unit();
        ASSERT_TRUE(isSoundFrom(mesh, view, tolerancePx)) << i;
    }
}

TEST_P(Sheets, HaveNestedBounds)
{
    std::size_t looked = 0;
    const PlacedTile& placed = tile->tile;
    const auto look = [&](GridPoint v)
    {
        const bool isCorner = (v.column == 0 || v.column == placed.grid().side() - 1) &&
                              (v.row == 0 || v.row == placed.grid().side() - 1);
        if (isCorner) return;
        const SplitBound bound = tile->bound(v);
        ++looked;
        SplitDiamond(v, placed.grid().side())
            .forEachChild(
                [&](GridPoint c)
                {
                    const SplitBound child = tile->bound(c);
                    ASSERT_GE(bound.errorM, child.errorM) << v.column << ", " << v.row;
                    const double reachM =
                        glm::distance(glm::dvec3(bound.centre), glm::dvec3(child.centre)) + child.radiusM;
                    ASSERT_TRUE(child.errorM == 0.0f || bound.radiusM >= reachM);
                });
    };
    GridRect{0, 0, placed.grid().side() - 1, placed.grid().side() - 1}.forEachMultipleOf(1,
                                                                                         [&](int c, int r) {
                                                                                             look({c, r});
                                                                                         });
    EXPECT_GT(looked, 100000u);
}

TEST_P(Sheets, AreTheSameForAllDrivers)
{
    Random random(17);
    std::vector<std::unique_ptr<RoamMesh>> meshes;
    for (const Driver driver : {Driver::wheel, Driver::walk, Driver::queue})
        meshes.push_back(std::make_unique<RoamMesh>(SplitBounds(tile), driver));
    for (int i = 0; i < 12; ++i)
    {
        const viewlod::ViewState view = randomView(random);
        for (const auto& mesh : meshes)
        {
            mesh->refine(view, {.errorTolerancePx = 1.0});
            ASSERT_EQ(testsupport::leafSet(mesh->tree()), testsupport::leafSet(meshes.front()->tree())) << i;
        }
    }
}

TEST_P(Sheets, AreEditedLikeTheRaster)
{
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)};
    Random random(27);
    std::vector<GridPoint> edited;
    std::vector<SplitBound> before;
    const auto snapshot = [&]
    {
        std::vector<SplitBound> bounds;
        for (int r = 0; r < tile->tile.grid().dataRows(); r += 2)
            for (int c = 0; c < tile->tile.grid().dataColumns(); c += 2)
                if (c + r > 0) bounds.push_back(tile->bound({c, r}));
        return bounds;
    };
    before = snapshot();
    for (int i = 0; i < 40; ++i)
    {
        const bool stays = random.below(3) == 0;
        GridPoint p{static_cast<int>(random.below(18 * 16)), static_cast<int>(random.below(15 * 16))};
        if (!stays && !tile->tile.samples().hasSample(p.column, p.row)) p = {p.column & -4, p.row & -4};
        if (!stays && !tile->tile.samples().hasSample(p.column, p.row)) p = {p.column & -16, p.row & -16};
        const HeightChange change{p, 400.0f + 200.0f * static_cast<float>(random.unit())};
        ASSERT_TRUE(
            editor.apply({&change, 1}, stays ? TileEditor::Between::stays : TileEditor::Between::follows));
        ASSERT_NEAR(tile->tile.samples().heightM(p.column, p.row), change.heightM, 0.001);
        const viewlod::ViewState view = randomView(random);
        ASSERT_TRUE(isSoundFrom(mesh, view, 1.5)) << i;
    }
    while (editor.undo())
    {
    }
    const std::vector<SplitBound> after = snapshot();
    for (std::size_t i = 0; i < after.size(); ++i)
        ASSERT_TRUE(after[i].errorM == before[i].errorM && after[i].radiusM == before[i].radiusM &&
                    after[i].centre == before[i].centre);
}

TEST_P(Sheets, WouldBeMissedWithoutTheirBounds)
{
    // The raster's own mesh, drawn where the sheets are: the check sees what it lacks.
    HeightField bare = field(40, 33);
    bare.parts.clear();
    if (GetParam()) bare = testsupport::onTheEarth(std::move(bare));
    const auto without = std::make_shared<RoamTile>(
        PlacedTile(std::move(bare),
                   {.placement = GetParam() ? Placement::curved : Placement::planar, .gridExponent = 4}));
    RoamMesh mesh{SplitBounds(without)};
    Random random(7);
    const viewlod::ViewState view = randomView(random);
    mesh.refine(view, {.errorTolerancePx = 1.0});
    const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), &view);
    EXPECT_TRUE(report.cracks > 0 || report.maxErrorPx > 1.0);
}

INSTANTIATE_TEST_SUITE_P(Placed, Sheets, testing::Bool(),
                         [](const auto& given) { return given.param ? "curved" : "planar"; });

} // namespace
