// SPDX-License-Identifier: Apache-2.0
// Tests blocks of progressive meshes that overlap: by the brute-force check of the uppermost surface, and by
// rays against all triangles.
#include <osgTerrainROAM/core/blocks/VipmMesh.h>
#include <osgTerrainROAM/core/edit/TileEditor.h>
#include <osgTerrainROAM/core/heightfield/DemImport.h>

#include "BlockMeshCheck.h"
#include "RayCheck.h"
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
using testsupport::RayCheck;
using testsupport::RayFindings;

constexpr double kTolerancePx = 3.0;

std::shared_ptr<const RoamTile> overlapTile(int columns = 161, int rows = 161)
{
    return testsupport::planarTile(testsupport::hills(columns, rows, 90.0));
}

PreparedVipm overlapping(std::shared_ptr<const RoamTile> tile)
{
    return PreparedVipm(std::move(tile), VipmBorders::overlapping);
}

viewlod::ViewState viewAt(const RoamTile& tile, int frame)
{
    return BenchmarkFlight{}.view(tile.tile, frame);
}

/// Casts rays through random pixels, and through points near the borders of blocks, where holes would be.
RayFindings castRays(const RoamTile& tile, const DrawnMesh& mesh, const viewlod::ViewState& view,
                     const BlockGrid& grid, std::uint64_t seed)
{
    constexpr int kPixels = 150, kBorders = 300;
    RayCheck rays(tile, mesh, view, kTolerancePx);
    testsupport::Random random(seed);
    const glm::dmat4 worldFromClip = glm::inverse(view.clipFromWorld);
    for (int i = 0; i < kPixels; ++i)
    {
        const glm::dvec4 far =
            worldFromClip * glm::dvec4(2.0 * random.unit() - 1.0, 2.0 * random.unit() - 1.0, 0.9, 1.0);
        rays.cast(glm::dvec3(far) / far.w);
    }
    const double cellM = tile.tile.field().spacingEastM;
    for (int i = 0; i < kBorders; ++i)
    {
        const int line = grid.side() *
                         (1 + static_cast<int>(random.below(static_cast<std::uint32_t>(grid.columns() - 1)))),
                  along = static_cast<int>(
                      random.below(static_cast<std::uint32_t>(tile.tile.grid().dataRows() - 1)));
        const GridPoint p = i % 2 == 0 ? GridPoint{line, along} : GridPoint{along, line};
        const glm::dvec3 ground = tile.tile.position(p.column, p.row);
        const double offM = kTolerancePx * glm::distance(ground, view.eyeWorld) / view.pixelsPerTangent;
        rays.cast(ground + glm::dvec3(0.2 * (random.unit() - 0.5) * cellM,
                                      0.2 * (random.unit() - 0.5) * cellM, (random.unit() - 0.5) * offM));
    }
    return rays.findings;
}

/// Findings over some frames of the flight; `spoil` changes the drawn mesh before.
struct FlightCheck
{
    std::size_t bareEdges = 0;
    RayFindings rays;
};
FlightCheck flyAndCheck(const std::function<void(DrawnMesh&)>& spoil)
{
    static const auto tile = overlapTile();
    static const PreparedVipm prepared = overlapping(tile);
    FlightCheck found;
    const auto mesh = prepared.newMesh();
    for (int frame = 0; frame < 120; frame += 15)
    {
        const auto view = viewAt(*tile, frame);
        mesh->refine(view, {.errorTolerancePx = kTolerancePx});
        DrawnMesh drawn = mesh->drawn();
        spoil(drawn);
        found.bareEdges += checkDrawnMesh(*tile, drawn, nullptr).tJunctions;
        const RayFindings rays =
            castRays(*tile, drawn, view, prepared.blocks()->grid(), static_cast<std::uint64_t>(frame) + 1);
        found.rays.deep += rays.deep;
        found.rays.missed += rays.missed;
        found.rays.fromBelow += rays.fromBelow;
    }
    return found;
}

TEST(VipmOverlap, NoRayPassesBetweenTheBlocks)
{
    const FlightCheck found = flyAndCheck([](DrawnMesh&) {});
    EXPECT_EQ(found.bareEdges, 0u);
    EXPECT_GT(found.rays.deep, 500u);
    EXPECT_EQ(found.rays.missed, 0u);
    EXPECT_EQ(found.rays.fromBelow, 0u);
}

TEST(VipmOverlap, WithoutRimsHolesAreFound)
{
    const FlightCheck found = flyAndCheck(
        [](DrawnMesh& mesh)
        { std::erase_if(mesh.triangles, [&](const LeafTriangle& t) { return mesh.isSunk(t); }); });
    EXPECT_GT(found.bareEdges, 0u);
    EXPECT_GT(found.rays.missed + found.rays.fromBelow, 0u);
}

TEST(VipmOverlap, ARimThatIsMissingAtOneBlockIsFound)
{
    const FlightCheck found = flyAndCheck(
        [](DrawnMesh& mesh)
        {
            const GridRect block{64, 64, 96, 96};
            const auto isOfBlock = [&](std::uint32_t v)
            { return block.holds(mesh.grid[v].column, mesh.grid[v].row) != mesh.sunk[v]; };
            std::erase_if(mesh.triangles, [&](const LeafTriangle& t)
                          { return mesh.isSunk(t) && std::all_of(t.vertices, t.vertices + 3, isOfBlock); });
        });
    EXPECT_GT(found.bareEdges, 0u);
}

TEST(VipmOverlap, RimsThatAreNotSunkAreFound)
{
    const auto tile = overlapTile();
    const FlightCheck found = flyAndCheck(
        [&](DrawnMesh& mesh)
        {
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
                if (mesh.sunk[v])
                    mesh.vertices[v] = meshVertex(tile->tile.position(mesh.grid[v].column, mesh.grid[v].row) -
                                                      glm::dvec3(0.0, 0.0, mesh.stepM),
                                                  mesh.grid[v], mesh.stepM);
        });
    EXPECT_GT(found.bareEdges, 0u);
}

TEST(VipmOverlap, BordersAreSimplifiedDownToTwoTriangles)
{
    const auto tile = overlapTile();
    const auto locked = PreparedVipm(tile).blocks(), open = overlapping(tile).blocks();
    const std::uint32_t middle = open->grid().blockAt(2, 2);
    EXPECT_GT(locked->block(middle).levels.back().triangles, 120u);
    EXPECT_EQ(open->block(middle).levels.back().triangles, 10u) << "two, and two of the rim on each side";
    EXPECT_EQ(open->block(middle).levels.front().triangles, 2048u + 256u);
    EXPECT_EQ(open->block(0).levels.front().triangles, 2048u + 128u) << "two sides at the edge of the data";
    for (std::uint32_t i = 0; i < open->grid().count(); ++i)
        for (std::size_t k = 1; k < open->block(i).levels.size(); ++k)
        {
            EXPECT_LT(open->block(i).levels[k].triangles, open->block(i).levels[k - 1].triangles);
            EXPECT_GE(open->block(i).levels[k].errorM, open->block(i).levels[k - 1].errorM);
        }
}

TEST(VipmOverlap, DrawsRastersOfAnySize)
{
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 17}, {33, 33}, {34, 33}, {65, 40}, {34, 98}})
    {
        const auto tile = overlapTile(columns, rows);
        const PreparedVipm prepared = overlapping(tile);
        const auto mesh = prepared.newMesh();
        const auto view = viewAt(*tile, 0);
        mesh->refine(view, {.errorTolerancePx = kTolerancePx});
        EXPECT_TRUE(isSound(*mesh, view, kTolerancePx)) << columns << 'x' << rows;
        for (const double errorM : {1e9, 40.0, 4.0, 0.0})
        {
            const RefineResult result = mesh->refine(errorM);
            const auto report = checkDrawnMesh(*tile, mesh->drawn(), nullptr);
            EXPECT_EQ(report.tJunctions + report.cracks, 0u) << columns << 'x' << rows << ' ' << errorM;
            EXPECT_EQ(result.triangles, mesh->drawn().triangles.size());
            EXPECT_GE(result.triangles, prepared.fewestTriangles());
        }
    }
}

TEST(VipmOverlap, KeepsTheBoundOnTheRoundEarthToo)
{
    testsupport::expectSoundOnTheRoundEarth(overlapping);
}

TEST(VipmOverlap, OnTheRoundEarthBlocksComeDownToAsFewTriangles)
{
    const auto field = testsupport::hills(100, 75, 90.0);
    const auto earth =
        std::make_shared<const RoamTile>(PlacedTile(testsupport::onTheEarth(field), Placement::curved));
    // Parallels are bent in the local frame: simplified there, the blocks kept 5033 triangles in place of 92.
    EXPECT_EQ(overlapping(earth).fewestTriangles(), overlapping(overlapTile(100, 75)).fewestTriangles());
}

TEST(VipmOverlap, ErrorsTooSmallAreFound)
{
    const auto tile = overlapTile(97, 97);
    const auto small = VipmMutation::copyOf(*overlapping(tile).blocks());
    VipmMutation::scaleErrors(*small, 0.2f);
    VipmMesh mesh(small);
    double largestPx = 0.0;
    for (int frame = 0; frame < 120; frame += 12)
    {
        const auto view = viewAt(*tile, frame);
        mesh.refine(view, {.errorTolerancePx = kTolerancePx});
        largestPx = std::max(largestPx, checkDrawnMesh(*tile, mesh.drawn(), &view).maxErrorPx);
    }
    EXPECT_GT(largestPx, kTolerancePx);
}

TEST(VipmOverlap, FollowsEditsThatLowerAWholeNeighbourhood)
{
    const auto tile =
        std::make_shared<RoamTile>(PlacedTile(testsupport::hills(100, 100, 30.0), Placement::planar));
    TileEditor editor(tile);
    const PreparedVipm prepared = overlapping(tile);
    const auto mesh = prepared.newMesh();
    testsupport::Random random(3);
    for (int frame = 0; frame < 6; ++frame)
    {
        const GridPoint place{static_cast<int>(random.below(100)), static_cast<int>(random.below(100))};
        const HeightChange change{place, static_cast<float>(frame % 2 == 0 ? -3000.0 : 700.0)};
        ASSERT_TRUE(editor.apply({&change, 1}, TileEditor::Between::follows));
        const auto view = viewAt(*tile, frame);
        mesh->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_TRUE(isSound(*mesh, view, 2.0)) << frame;
        const auto late = prepared.newMesh();
        late->refine(view, {.errorTolerancePx = 2.0});
        ASSERT_EQ(testsupport::pictured(*late), testsupport::pictured(*mesh)) << frame;
    }
}

class VipmOverlapFlight : public testing::TestWithParam<measurement::RasterCrop>
{
};

TEST_P(VipmOverlapFlight, IsSound)
{
    constexpr int kEachOf = 41; // 1: every frame
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    measurement::RasterCrop part = GetParam();
    part.side = 257;
    const auto tile = testsupport::planarTile(part.of(*imported));
    const PreparedVipm prepared = overlapping(tile);
    const auto mesh = prepared.newMesh();
    RayFindings rays;
    for (const Path path : {Path::flight, Path::drive, Path::jump})
        for (int frame = 0; frame < BenchmarkFlight::kFrames; frame += kEachOf)
        {
            const auto view = BenchmarkFlight::along(path).view(tile->tile, frame);
            mesh->refine(view, {.errorTolerancePx = kTolerancePx});
            ASSERT_TRUE(isSound(*mesh, view, kTolerancePx)) << pathName(path) << ' ' << frame;
            const RayFindings found = castRays(*tile, mesh->drawn(), view, prepared.blocks()->grid(), 7);
            rays.deep += found.deep;
            ASSERT_EQ(found.missed + found.fromBelow, 0u) << pathName(path) << ' ' << frame;
        }
    EXPECT_GT(rays.deep, 100u);
}

INSTANTIATE_TEST_SUITE_P(Crops, VipmOverlapFlight,
                         testing::Values(measurement::kWhiteMountains, measurement::kAconcagua,
                                         measurement::kGreenRiver),
                         [](const auto& given)
                         { return std::filesystem::path(given.param.file).stem().string().substr(0, 6); });

} // namespace
