// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/vdpm/BuildForest.h>
#include <osgTerrainROAM/core/vdpm/HeightFieldForest.h>
#include <osgTerrainROAM/core/vdpm/VdpmMesh.h>

#include "RealData.h"
#include "SurfaceError.h"
#include "SyntheticField.h"
#include "measurement/flights/RasterCrop.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr double kStepsM = 2e-3; ///< vertices are drawn in whole steps

std::shared_ptr<const BoundedForest> forestOf(const RoamTile& tile)
{
    auto forest = heightFieldForest(tile.tile);
    EXPECT_TRUE(forest);
    return std::make_shared<const BoundedForest>(std::move(*forest));
}

TEST(HeightFieldForest, BoundsNestAndTheBaseIsTwoTriangles)
{
    const auto tile = testsupport::planarTile(testsupport::hills(33, 33));
    const auto forest = forestOf(*tile);
    EXPECT_TRUE(areBoundsNested(*forest));
    EXPECT_EQ(forest->forest.rootFaces.size(), 2u);
    EXPECT_EQ(forest->forest.vertexCount(), 33u * 33u);
    BoundedForest damaged = *forest;
    const auto inner = std::ranges::find_if(damaged.finder, [](std::uint32_t f) { return f != kNone; });
    damaged.bounds[*inner].radiusM *= 0.5f;
    EXPECT_FALSE(areBoundsNested(damaged));
}

TEST(HeightFieldForest, KeepsEveryErrorInPlaneAndOnTheEarth)
{
    const auto plane = testsupport::planarTile(testsupport::hills(41, 29), Storage::exact);
    const auto earth = std::make_shared<const RoamTile>(
        PlacedTile(testsupport::onTheEarth(testsupport::hills(41, 29)), Placement::curved, Storage::exact));
    for (const auto& tile : {plane, earth})
    {
        VdpmMesh mesh(tile, forestOf(*tile));
        std::uint32_t before = ~0u;
        for (const double errorM : {1.0, 3.0, 10.0, 40.0, 150.0})
        {
            const RefineResult result = mesh.refine(errorM);
            EXPECT_LT(result.triangles, before);
            before = result.triangles;
            EXPECT_TRUE(mesh.isValid());
            const auto error = testsupport::surfaceError(*tile, mesh.drawn(), nullptr);
            EXPECT_LE(error.errorM, errorM + kStepsM);
            EXPECT_EQ(error.uncovered, 0u);
        }
        mesh.refine(-1.0);
        EXPECT_EQ(mesh.triangleSlots(), 2u * 40u * 28u);
        EXPECT_LE(testsupport::surfaceError(*tile, mesh.drawn(), nullptr).errorM, kStepsM);
    }
}

TEST(HeightFieldForest, ATooSmallErrorOfOneVertexIsFound)
{
    const auto tile = testsupport::planarTile(testsupport::hills(33, 33), Storage::exact);
    const auto forest = forestOf(*tile);
    constexpr double kErrorM = 20.0;
    int found = 0;
    for (std::uint32_t w = 0; w < forest->forest.splitCount(); ++w)
    {
        if (forest->bounds[w].errorM <= kErrorM) continue;
        auto damaged = std::make_shared<BoundedForest>(*forest);
        damaged->bounds[w].errorM = 0.0f;
        VdpmMesh mesh(tile, damaged);
        mesh.refine(kErrorM);
        found += testsupport::surfaceError(*tile, mesh.drawn(), nullptr).errorM > kErrorM + kStepsM;
    }
    EXPECT_GT(found, 0);
}

TEST(HeightFieldForest, EqualBallsNest)
{
    const auto tile = testsupport::planarTile(testsupport::hills(17, 17));
    const auto made = heightFieldForest(tile->tile);
    ASSERT_TRUE(made);
    SplitBound ball = made->bounds.front();
    ball.radiusM = 1234.5f;
    const std::vector<SplitBound> equal(made->forest.splitCount(), ball);
    BoundedForest forest = nestBounds(made->forest, made->positions, equal);
    EXPECT_TRUE(areBoundsNested(forest))
        << "of equal balls the distance is 0, by which nothing may be divided";
    forest.bounds.front().radiusM = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(areBoundsNested(forest)) << "the control";
}

/// Says of every collapse what it is told to.
struct Verdict final : CollapseWitness
{
    explicit Verdict(bool allowed) : allows(allowed) {}
    bool collapse(const CollapsedStar&) override { return allows; }
    bool allows;
};

TEST(HeightFieldForest, CollapsesThatAreNotAllowedAreLeftOut)
{
    const std::vector<Triangle> fan{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    const std::vector<EdgeCollapse> collapses{{4, 0}};
    for (const bool allows : {false, true})
    {
        Verdict witness(allows);
        const VertexForest forest = buildForest(fan, 5, collapses, &witness);
        EXPECT_EQ(forest.splitCount(), allows ? 1u : 0u);
        EXPECT_EQ(forest.rootFaces.size(), allows ? 2u : 4u);
    }
}

TEST(HeightFieldForest, NoTriangleOfAnyLevelIsTurnedOver)
{
    for (const std::uint64_t seed : {1, 2, 3})
    {
        const auto tile = testsupport::planarTile(testsupport::hills(65, 49, 30.0, seed));
        VdpmMesh mesh(tile, forestOf(*tile));
        for (const double errorM : {1e9, 300.0, 100.0, 30.0})
        {
            mesh.refine(errorM);
            const DrawnMeshReport report = checkDrawnMesh(*tile, mesh.drawn(), nullptr);
            EXPECT_EQ(report.tJunctions + report.cracks, 0u) << seed << ' ' << errorM;
        }
    }
}

TEST(HeightFieldForest, RefusesWhatItCannotFollow)
{
    HeightField field = testsupport::hills(17, 17);
    std::vector<std::uint8_t> isThere(17 * 17, 1);
    isThere[5 * 17 + 5] = 0;
    field.mask = SampleMask(isThere, 17, 17);
    const PlacedTile tile(field, Placement::planar);
    const auto forest = heightFieldForest(tile);
    ASSERT_FALSE(forest);
    EXPECT_NE(forest.error().message().find("holes"), std::string::npos);
}

/// Triangles of Hoppe's progressive mesh at equal true error on the crops that methods are compared on.
struct HoppeRow
{
    measurement::RasterCrop crop;
    std::vector<std::pair<double, std::uint32_t>> trianglesAtErrorM;
};

class HoppeRows : public testing::TestWithParam<HoppeRow>
{
};

TEST_P(HoppeRows, AreMetWithinFifteenPercent)
{
    OSGTRAINER_REAL_DATA_OR_SKIP(file, GetParam().crop.file);
    const auto imported = importDem(file);
    ASSERT_TRUE(imported) << imported.error().message();
    const auto tile = testsupport::planarTile(GetParam().crop.of(*imported), Storage::exact);
    VdpmMesh mesh(tile, forestOf(*tile));
    for (const auto& [errorM, triangles] : GetParam().trianglesAtErrorM)
    {
        EXPECT_LE(mesh.refine(errorM).triangles, 1.15 * triangles) << errorM;
        EXPECT_LE(testsupport::surfaceError(*tile, mesh.drawn(), nullptr).errorM, errorM + kStepsM);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Crops, HoppeRows,
    testing::Values(HoppeRow{measurement::kWhiteMountains, {{20, 49247}, {10, 136873}, {5, 348491}}},
                    HoppeRow{measurement::kAconcagua, {{50, 60205}, {20, 244090}}},
                    HoppeRow{measurement::kGreenRiver, {{1, 449}, {0.5, 1420}, {0.25, 4155}, {0.1, 19994}}}),
    [](const auto& row) { return std::filesystem::path(row.param.crop.file).stem().string().substr(0, 6); });

} // namespace

} // namespace osgTerrainROAM::core
