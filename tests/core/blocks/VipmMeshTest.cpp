// SPDX-License-Identifier: Apache-2.0
#include <iostream>

#include <osgTerrainROAM/core/blocks/VipmMesh.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "BlockMeshCheck.h"
#include "RealData.h"
#include "SyntheticField.h"
#include "VipmMutation.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;
using measurement::Path;
using testsupport::isSound;

std::shared_ptr<const RoamTile> hillTile(int columns = 97, int rows = 97)
{
    return testsupport::planarTile(testsupport::hills(columns, rows, 90.0));
}

viewlod::ViewState viewOver(const RoamTile& tile, int frame)
{
    return BenchmarkFlight{}.view(tile.tile, frame);
}

TEST(VipmBlocks, LevelsAreALadderWithErrorsThatGrow)
{
    const auto blocks = PreparedVipm(hillTile()).blocks();
    for (std::uint32_t i = 0; i < blocks->grid().count(); ++i)
    {
        const std::vector<VipmLevel>& levels = blocks->block(i).levels;
        ASSERT_GT(levels.size(), 5u);
        EXPECT_EQ(levels.front().triangles, 2048u);
        EXPECT_LT(levels.front().errorM, 1e-6f);
        for (std::size_t k = 1; k < levels.size(); ++k)
        {
            EXPECT_LT(levels[k].triangles, levels[k - 1].triangles);
            EXPECT_GE(levels[k].errorM, levels[k - 1].errorM);
        }
        EXPECT_GE(levels.back().triangles, 4u * 32u - 2u)
            << "a border of 128 vertices has no fewer triangles";
        EXPECT_LT(levels.back().triangles, 4u * 32u * 2u);
    }
}

TEST(VipmMesh, DrawsRastersOfAnySize)
{
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 17}, {33, 33}, {34, 33}, {65, 40}})
    {
        const auto tile = hillTile(columns, rows);
        const PreparedVipm prepared(tile);
        const auto mesh = prepared.newMesh();
        const auto view = viewOver(*tile, 0);
        mesh->refine(view, {.errorTolerancePx = 3.0});
        EXPECT_TRUE(isSound(*mesh, view, 3.0)) << columns << 'x' << rows;
        for (const double errorM : {1e9, 40.0, 4.0, 0.0})
        {
            const RefineResult result = mesh->refine(errorM);
            const auto report = checkDrawnMesh(*tile, mesh->drawn(), nullptr);
            EXPECT_EQ(report.tJunctions + report.cracks, 0u) << columns << 'x' << rows << ' ' << errorM;
            EXPECT_GE(result.triangles, prepared.fewestTriangles());
        }
    }
}

TEST(VipmMesh, KeepsTheBoundOnTheRoundEarthToo)
{
    testsupport::expectSoundOnTheRoundEarth([](const auto& tile) { return PreparedVipm(tile); });
}

TEST(VipmMesh, ErrorsTooSmallAndBordersNotLockedAreFound)
{
    const auto tile = hillTile();
    const auto right = PreparedVipm(tile).blocks();
    const auto small = VipmMutation::copyOf(*right), open = VipmMutation::copyOf(*right);
    VipmMutation::scaleErrors(*small, 0.2f);
    VipmMutation::unlock(*open);
    const auto unsoundFrames = [&](const std::shared_ptr<const VipmBlocks>& blocks, bool forJunctions)
    {
        VipmMesh mesh(blocks);
        int unsound = 0;
        for (int frame = 0; frame < 120; frame += 12)
        {
            const auto view = viewOver(*tile, frame);
            mesh.refine(view, {.errorTolerancePx = 3.0});
            const auto report = checkDrawnMesh(*tile, mesh.drawn(), &view);
            unsound += forJunctions ? report.tJunctions > 0 : report.maxErrorPx > 3.0;
        }
        return unsound;
    };
    EXPECT_EQ(unsoundFrames(right, false) + unsoundFrames(right, true), 0);
    EXPECT_GT(unsoundFrames(small, false), 0);
    EXPECT_GT(unsoundFrames(open, true), 0);
}

TEST(VipmMesh, IsAFunctionOfTheEyeAndWritesWhatChanges)
{
    const auto tile = hillTile();
    const PreparedVipm prepared(tile);
    const auto travelled = prepared.newMesh(), fresh = prepared.newMesh();
    for (int frame = 0; frame <= 100; frame += 5)
    {
        travelled->refine(viewOver(*tile, frame), {.errorTolerancePx = 3.0});
        ASSERT_TRUE(travelled->isValid());
    }
    fresh->refine(viewOver(*tile, 100), {.errorTolerancePx = 3.0});
    EXPECT_EQ(testsupport::pictured(*travelled), testsupport::pictured(*fresh));
    travelled->refine(viewOver(*tile, 100), {.errorTolerancePx = 3.0});
    EXPECT_TRUE(travelled->changes().vertices.empty() && travelled->changes().triangles.empty());
}

TEST(VipmMesh, TheCeilingRaisesTheTolerance)
{
    const auto tile = hillTile();
    const PreparedVipm prepared(tile);
    const auto mesh = prepared.newMesh();
    const auto view = viewOver(*tile, 0);
    const RefineResult free = mesh->refine(view, {.errorTolerancePx = 0.5});
    const std::uint32_t most = std::max(free.triangles / 2, prepared.fewestTriangles());
    const RefineResult bound = mesh->refine(view, {.errorTolerancePx = 0.5, .maxTriangles = most});
    EXPECT_LE(bound.triangles, most);
    EXPECT_TRUE(bound.ceilingBound && bound.tolerancePx > 0.5);
    EXPECT_TRUE(isSound(*mesh, view, bound.tolerancePx));
}

TEST(VipmMesh, FollowsEdits)
{
    const auto tile =
        std::make_shared<RoamTile>(PlacedTile(testsupport::hills(70, 60, 30.0), Placement::planar));
    TileEditor editor(tile);
    const PreparedVipm prepared(tile);
    const auto mesh = prepared.newMesh();
    testsupport::Random random(3);
    for (int frame = 0; frame < 6; ++frame)
    {
        const GridPoint place{static_cast<int>(random.below(70)), static_cast<int>(random.below(60))};
        const HeightChange change{place, static_cast<float>(300.0 + 400.0 * random.unit())};
        ASSERT_TRUE(editor.apply({&change, 1}, TileEditor::Between::follows));
        EXPECT_TRUE(mesh->isBehind());
        const auto view = viewOver(*tile, frame);
        mesh->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_FALSE(mesh->isBehind());
        ASSERT_TRUE(isSound(*mesh, view, 2.0)) << frame;
        const auto late = prepared.newMesh();
        late->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_EQ(testsupport::pictured(*late), testsupport::pictured(*mesh)) << frame;
    }
}

constexpr int kFramesBetween = 41; ///< 1: every frame

class VipmFlight : public testing::TestWithParam<measurement::RasterCrop>
{
};

TEST_P(VipmFlight, IsSound)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    measurement::RasterCrop part = GetParam();
    part.side = 257;
    const auto tile = testsupport::planarTile(part.of(*imported));
    const PreparedVipm prepared(tile);
    const auto mesh = prepared.newMesh();
    for (const Path path : {Path::flight, Path::drive, Path::jump})
        for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += kFramesBetween)
        {
            const auto view = BenchmarkFlight::along(path).view(tile->tile, frame);
            mesh->refine(view, {.errorTolerancePx = 2.0});
            ASSERT_TRUE(isSound(*mesh, view, 2.0)) << pathName(path) << ' ' << frame;
        }
}

INSTANTIATE_TEST_SUITE_P(Crops, VipmFlight,
                         testing::Values(measurement::kWhiteMountains, measurement::kAconcagua,
                                         measurement::kGreenRiver),
                         [](const auto& given)
                         { return std::filesystem::path(given.param.file).stem().string().substr(0, 6); });

} // namespace
