// SPDX-License-Identifier: Apache-2.0
// Meshes whose leaves carry patches: what is drawn is checked from outside, sample by sample.
#include <map>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <viewlod/ScreenError.h>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/DrawnMeshCheck.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "SyntheticField.h"
#include "TreeWalks.h"

namespace
{

using namespace osgTerrainROAM::core;
using testsupport::leafSet;
using testsupport::Random;

std::shared_ptr<const RoamTile> tileOfPatches(bool curved)
{
    HeightField field = testsupport::hills(100, 129); // padded: patches reach beyond the data
    return std::make_shared<const RoamTile>(curved ? PlacedTile(testsupport::onTheEarth(std::move(field)))
                                                   : PlacedTile(std::move(field), Placement::planar));
}

viewlod::ViewState viewOfPatches(const PlacedTile& tile, Random& random)
{
    const glm::dvec3 eye =
        tile.frame().positionAt(random.unit() * 99.0, random.unit() * 128.0, 700.0 + 1500.0 * random.unit());
    const glm::dvec3 target = tile.frame().positionAt(random.unit() * 99.0, random.unit() * 128.0, 300.0);
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, target, {0.01, 0.02, 1.0}),
                                            glm::perspective(1.0, 1.25, 1.0, 1e5), 1280, 1024);
}

using PatchSetting = std::tuple<int, bool>;

class Patches : public testing::TestWithParam<PatchSetting>
{
protected:
    const int _exponent = std::get<0>(GetParam());
    const std::shared_ptr<const RoamTile> _tile = tileOfPatches(std::get<1>(GetParam()));
    const SplitBounds _bounds{_tile, _exponent};
    Random _random{static_cast<std::uint64_t>(31 + _exponent)};
};

TEST_P(Patches, MeetAndKeepTheTolerance)
{
    RoamMesh mesh(_bounds);
    double largestShare = 0.0;
    std::uint32_t most = 0;
    for (const double tolerancePx : {40.0, 16.0, 8.0, 4.0, 16.0, 100.0, 4.0})
    {
        const viewlod::ViewState view = viewOfPatches(_tile->tile, _random);
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = tolerancePx});
        const DrawnMesh drawn = mesh.drawn();
        EXPECT_EQ(drawn.triangles.size(), result.triangles);
        const DrawnMeshReport report = checkDrawnMesh(*_tile, drawn, &view);
        EXPECT_EQ(report.tJunctions, 0u);
        EXPECT_EQ(report.cracks, 0u);
        EXPECT_LE(report.maxErrorPx, tolerancePx);
        EXPECT_TRUE(mesh.isConforming());
        largestShare = std::max(largestShare, report.maxErrorPx / tolerancePx);
        most = std::max(most, result.leaves >> _exponent);
    }
    EXPECT_GT(most, 50u) << "nothing was refined: nothing was checked";
    EXPECT_GT(largestShare, 0.1);
}

TEST_P(Patches, OfAllDriversAreTheSame)
{
    for (const Driver driver : kDrivers)
    {
        Random random(5);
        RoamMesh mesh(_bounds, driver);
        for (int i = 0; i < 20; ++i)
        {
            const viewlod::ViewState view = viewOfPatches(_tile->tile, random);
            const double tolerancePx = 2.0 + 30.0 * random.unit();
            mesh.refine(view, {.errorTolerancePx = tolerancePx});
            std::vector<GridTriangle> scratch;
            refineFromScratch(_bounds, view, tolerancePx, scratch);
            EXPECT_EQ(leafSet(mesh.tree()), leafSet(scratch)) << driverName(driver);
        }
    }
}

TEST_P(Patches, KeepTheirSlotsAsLongAsTheirLeavesLive)
{
    RoamMesh mesh(_bounds);
    const PatchPool& pool = *mesh.patches();
    std::map<std::array<int, 6>, std::uint32_t> before; // grid triangle to slot
    std::size_t kept = 0, writes = 0;
    viewlod::ViewState view = viewOfPatches(_tile->tile, _random);
    for (int frame = 0; frame < 100; ++frame)
    {
        view.eyeWorld += glm::dvec3(20.0, 10.0, 0.0);
        if (frame % 25 == 0) view = viewOfPatches(_tile->tile, _random);
        mesh.refine(view, {.errorTolerancePx = 8.0});
        std::map<std::array<int, 6>, std::uint32_t> now;
        std::vector<bool> taken(pool.slotCount(), false);
        const LeafArena& leaves = mesh.tree().leaves();
        for (std::uint32_t i = 0; i < leaves.slotCount(); ++i)
        {
            const TriangleId leaf = leaves.leaf(i);
            if (!leaf.exists()) continue;
            const std::uint32_t slot = pool.slotOf(leaf);
            ASSERT_LT(slot, pool.slotCount());
            ASSERT_FALSE(taken[slot]) << "two leaves in one slot";
            taken[slot] = true;
            ASSERT_EQ(pool.leaf(slot), leaf);
            now[testsupport::cornersOf(mesh.tree().gridTriangle(leaf))] = slot;
        }
        for (std::uint32_t slot = 0; slot < pool.slotCount(); ++slot)
            ASSERT_EQ(pool.leaf(slot).exists(), taken[slot]) << "a slot that nobody has";
        for (const auto& [triangle, slot] : now)
            if (const auto found = before.find(triangle); found != before.end())
            {
                const bool isWritten = std::count(pool.written().begin(), pool.written().end(), slot) > 0;
                if (found->second == slot && !isWritten) ++kept;
            }
        writes += pool.written().size();
        before = std::move(now);
    }
    EXPECT_GT(kept, 5 * writes);
}

TEST_P(Patches, StayBelowTheCeilingAndFillIt)
{
    RoamMesh mesh(_bounds);
    int bound = 0;
    for (int i = 0; i < 30; ++i)
    {
        const viewlod::ViewState view = viewOfPatches(_tile->tile, _random);
        const std::uint32_t ceiling = (20u + _random.below(200)) << _exponent;
        const RefineResult result = mesh.refine(view, {.errorTolerancePx = 0.5, .maxTriangles = ceiling});
        EXPECT_LE(result.leaves, ceiling);
        if (!result.ceilingBound) continue;
        ++bound;
        EXPECT_GE(result.leaves, ceiling - std::max(ceiling / 100, 4u << _exponent));
    }
    EXPECT_GT(bound, 0);
}

TEST_P(Patches, AreWhatDrawnGroundStandsOn)
{
    RoamMesh mesh(_bounds);
    double largest = 0.0;
    for (const double errorM : {60.0, 10.0, 1.0})
    {
        mesh.refine(errorM);
        const DrawnMesh drawn = mesh.drawn();
        for (int i = 0; i < 300; ++i)
        {
            const double column = 0.1 + _random.unit() * 98.8, row = 0.1 + _random.unit() * 127.8;
            const glm::dvec3 place = _tile->tile.frame().positionAt(column, row, 400.0);
            const auto ground = drawnGroundAt(mesh.tree(), place.x, place.y);
            const auto truth = groundAt(_tile->tile, place.x, place.y);
            ASSERT_TRUE(ground && truth);
            const double off = std::fabs(glm::dot(truth->position - ground->position, ground->normal));
            EXPECT_LE(off, ground->boundM + 1e-3);
            EXPECT_LE(ground->boundM, errorM);
            largest = std::max(largest, off);
        }
    }
    EXPECT_GT(largest, 0.5) << "nothing was simplified: nothing was checked";
    EXPECT_FALSE(drawnGroundAt(mesh.tree(), -1e5, 0.0));
    EXPECT_FALSE(drawnGroundAt(mesh.tree(), std::nan(""), 0.0));
}

TEST_P(Patches, AreCulledOneByOneAndNoneThatIsSeen)
{
    RoamMesh mesh(_bounds);
    std::size_t culled = 0;
    for (int i = 0; i < 20; ++i)
    {
        const viewlod::ViewState view = viewOfPatches(_tile->tile, _random);
        mesh.refine(view, {.errorTolerancePx = 8.0});
        std::vector<IndexRange> ranges;
        mesh.visibleRanges(view.frustum, ranges);
        std::vector<bool> seen(mesh.patches()->slotCount(), false);
        for (const IndexRange& range : ranges)
            for (std::uint32_t slot = range.first; slot < range.first + range.count; ++slot)
                seen[slot] = true;
        for (std::uint32_t slot = 0; slot < seen.size(); ++slot)
        {
            if (seen[slot] || !mesh.patches()->leaf(slot).exists()) continue;
            ++culled;
            const IndexRange alone{slot, 1};
            for (const MeshVertex& v : mesh.drawn({&alone, 1}).vertices)
            {
                const auto px = viewlod::projectPx(view, positionOf(v, _tile->tile.frame().vertexStepM()));
                EXPECT_FALSE(px && px->x > 0 && px->y > 0 && px->x < view.widthPx && px->y < view.heightPx);
            }
        }
    }
    EXPECT_GT(culled, 100u);
}

INSTANTIATE_TEST_SUITE_P(Tiles, Patches,
                         testing::Combine(testing::Values(2, 4, 6), testing::Values(false, true)));

} // namespace

TEST(SplitBounds, WithoutPatchesAreTheTiles)
{
    const auto tile = tileOfPatches(false);
    const SplitBounds bounds(tile);
    EXPECT_EQ(bounds.memoryBytes(), 0u);
    EXPECT_EQ(bounds.levels(), tile->tile.grid().levels());
    for (int i = 0; i < 100; ++i)
        EXPECT_EQ(bounds.bound({i, i + 3}).errorM, tile->bound({i, i + 3}).errorM);
}

// Patches of 2^k triangles with an odd k divide legs and bases differently: two leaves side by side would not
// meet.
TEST(SplitBounds, TakeEvenExponentsThatTheTileHasLevelsFor)
{
    const auto tile = tileOfPatches(false);
    EXPECT_EQ(SplitBounds(tile, 3).patchExponent(), 2);
    EXPECT_EQ(SplitBounds(tile, -2).patchExponent(), 0);
    EXPECT_EQ(SplitBounds(tile, 99).patchExponent(), SplitBounds::kMostExponent);
    const auto small = testsupport::planarTile(testsupport::hills(5, 5));
    EXPECT_EQ(SplitBounds(small, 99).patchExponent(), 4) << "two leaves that never split";
}

/// The mutation for MeetAndKeepTheTolerance: bounds that forget the patches' errors, and leaves that leave
/// one out.
TEST(SplitBounds, WrongErrorsAndLostPatchesAreNoticed)
{
    const auto tile = tileOfPatches(false);
    Random random(3);
    const viewlod::ViewState view = viewOfPatches(tile->tile, random);
    RoamMesh mesh(SplitBounds(tile, 4));
    mesh.refine(view, {.errorTolerancePx = 60.0});
    EXPECT_GT(checkDrawnMesh(*tile, mesh.drawn(), &view).maxErrorPx, 4.0);
    DrawnMesh drawn = mesh.drawn();
    drawn.triangles.resize(drawn.triangles.size() - 16);
    const DrawnMeshReport report = checkDrawnMesh(*tile, drawn, &view);
    EXPECT_GT(report.tJunctions + report.cracks, 0u);
}
