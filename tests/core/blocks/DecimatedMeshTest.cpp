// SPDX-License-Identifier: Apache-2.0
#include "DecimatedFlight.h"
#include "RuggedTile.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::drawnSamples;
using testsupport::isSound;
using testsupport::ruggedTile;
using testsupport::viewAt;

TEST(DecimatedMesh, DrawsRastersOfAnySize)
{
    for (const auto& [columns, rows] : {std::pair{2, 2}, {3, 17}, {33, 33}, {34, 33}, {65, 40}, {100, 129}})
        for (const bool morphs : {false, true})
        {
            const auto tile = ruggedTile(columns, rows);
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
    const auto tile = ruggedTile();
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
    const auto right = PreparedDecimation(ruggedTile()).errors();
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
    // A plain, and beside it waves that grow with the distance from it: the fans are off by more than the
    // block.
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
    const auto tile = ruggedTile();
    const auto right = PreparedDecimation(tile).errors();
    const auto wrong = std::make_shared<BlockErrors>(*right);
    BlockErrorsMutation::scale(*wrong, 0.2f);
    for (const bool morphs : {false, true})
    {
        EXPECT_EQ(framesBeyond(tile, right, morphs), 0);
        EXPECT_GT(framesBeyond(tile, wrong, morphs), 0);
    }
}

} // namespace
