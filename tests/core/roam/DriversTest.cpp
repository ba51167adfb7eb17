// SPDX-License-Identifier: Apache-2.0
// The drivers against brute force, from eye to eye without coherence; and what they do with a slice of time.
#include <array>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <viewlod/Sight.h>

#include <osgTerrainROAM/core/roam/ActiveInSight.h>
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

std::shared_ptr<const RoamTile> tileOf(bool padded, bool curved)
{
    HeightField field = testsupport::hills(padded ? 100 : 129, 129);
    if (!curved) return testsupport::planarTile(std::move(field));
    return std::make_shared<const RoamTile>(PlacedTile(testsupport::onTheEarth(std::move(field))));
}

/// Anywhere above and around the tile, with any field of view; only what refinement needs.
viewlod::ViewState anyView(const PlacedTile& tile, Random& random)
{
    viewlod::ViewState view;
    view.eyeWorld = tile.frame().positionAt((1.4 * random.unit() - 0.2) * tile.grid().side(),
                                            (1.4 * random.unit() - 0.2) * tile.grid().side(),
                                            200.0 + 2000.0 * random.unit() * random.unit());
    view.pixelsPerTangent = 200.0 * std::exp(3.0 * random.unit());
    view.cornerStretch = 1.0 + random.unit();
    view.nearM = 0.5 + 20.0 * random.unit();
    return view;
}

/// For every vertex that the bintree could split: whether it is split. Asks the predicate of each, not of its
/// parents.
template<class Active>
std::vector<char> activeByBruteForce(const RoamTile& tile, const Active& active)
{
    const int side = tile.tile.grid().side();
    std::vector<char> found;
    found.reserve(static_cast<std::size_t>(side) * side);
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
        {
            const bool corner = column % (side - 1) == 0 && row % (side - 1) == 0;
            found.push_back(!corner && active(tile.bound({column, row})));
        }
    return found;
}

std::vector<char> activeIn(const DiamondTree& tree)
{
    const auto side = static_cast<std::size_t>(tree.tile().tile.grid().side());
    std::vector<char> found(side * side, false);
    for (VertexSlot v = DiamondTree::kCorners; v < tree.vertexSlots(); ++v)
        if (const DiamondPlace& place = tree.place(v); !place.isFree())
            found[place.row * side + place.column] = true;
    return found;
}

using Setting = std::tuple<bool, bool>;

class Drivers : public testing::TestWithParam<Setting>
{
};

/// 250 eyes over each of four grounds, other ones over each. The drivers refine meshes of their own for the
/// same eyes, so that brute force looks once at each eye.
TEST_P(Drivers, AreWhereBruteForceIsForAThousandEyes)
{
    const auto [padded, curved] = GetParam();
    const auto tile = tileOf(padded, curved);
    std::vector<RoamMesh> meshes;
    for (const Driver driver : kDrivers)
        meshes.emplace_back(tile, driver);
    Random random(77 + (padded ? 1 : 0) + (curved ? 2 : 0));
    std::array<std::uint32_t, std::size(kDrivers)> most{};
    viewlod::ViewState view = anyView(tile->tile, random);
    double tolerancePx = 2.0;
    for (int i = 0; i < 250; ++i)
    {
        // Leaps, steps, changes of the lens and of the tolerance, alone and together.
        const std::uint32_t change = random.below(4);
        if (change == 0) view = anyView(tile->tile, random);
        if (change == 1)
            view.eyeWorld += glm::dvec3(random.unit() - 0.5, random.unit() - 0.5, 0.1 * random.unit()) * 60.0;
        if (change == 2) view.pixelsPerTangent *= 0.8 + 0.4 * random.unit();
        if (change == 3) tolerancePx = 0.5 * std::exp(3.0 * random.unit());
        const auto expected = activeByBruteForce(*tile, ActiveForEye(view, tolerancePx));
        for (std::size_t d = 0; d < meshes.size(); ++d)
        {
            const RefineResult result = meshes[d].refine(view, {.errorTolerancePx = tolerancePx});
            ASSERT_EQ(activeIn(meshes[d].tree()), expected) << driverName(kDrivers[d]) << ", eye " << i;
            EXPECT_EQ(result.errorBoundPx, tolerancePx);
            most[d] = std::max(most[d], result.leaves);
        }
    }
    for (std::size_t d = 0; d < meshes.size(); ++d)
    {
        EXPECT_TRUE(meshes[d].isConforming());
        EXPECT_GT(most[d], 3000u) << "nothing was refined: nothing was checked";
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, Drivers, testing::Combine(testing::Bool(), testing::Bool()),
                         [](const auto& given)
                         {
                             return std::string(std::get<0>(given.param) ? "OnPaddedData" : "OnWholeTile") +
                                    (std::get<1>(given.param) ? "Curved" : "Planar");
                         });

TEST(DriverSwitch, GoesOnFromAnyOtherDriversMesh)
{
    const auto tile = tileOf(false, false);
    RoamMesh mesh(tile);
    Random random(5);
    for (int i = 0; i < 60; ++i)
    {
        mesh.setDriver(kDrivers[random.below(3)]);
        if (random.below(5) == 0) mesh.refine(5.0); // for no eye at all
        const auto view = anyView(tile->tile, random);
        mesh.refine(view, {.errorTolerancePx = 2.0});
        ASSERT_EQ(activeIn(mesh.tree()), activeByBruteForce(*tile, ActiveForEye(view, 2.0))) << i;
    }
}

/// From above the tile, in any direction a little down.
viewlod::ViewState anyTurn(const PlacedTile& tile, Random& random)
{
    const glm::dvec3 eye = anyView(tile, random).eyeWorld;
    const double yaw = 2.0 * glm::pi<double>() * random.unit();
    return viewlod::ViewState::fromMatrices(
        glm::lookAt(eye, eye + glm::dvec3(std::cos(yaw), std::sin(yaw), -0.5), glm::dvec3(0, 0, 1)),
        glm::perspective(glm::radians(40.0), 1.25, 1.0, 1e5), 1280, 1024);
}

/// Turns on the spot, steps and leaps, with and without morphing of the sight: the mesh depends on the eye
/// and on what is in sight alone.
TEST(DriversInSight, AreWhereBruteForceIsAndKeepTheToleranceInTheFrame)
{
    for (const bool padded : {false, true})
    {
        const auto tile = tileOf(padded, padded);
        std::vector<RoamMesh> meshes;
        for (const Driver driver : kDrivers)
            meshes.emplace_back(tile, driver);
        RoamMesh around(tile);
        Random random(31);
        viewlod::ViewState view = anyTurn(tile->tile, random);
        std::uint64_t inSight = 0, allAround = 0;
        for (int i = 0; i < 120; ++i)
        {
            const viewlod::ViewState other = anyTurn(tile->tile, random);
            if (i % 3 == 0) view = other;
            viewlod::Sight sight; // every tenth is everything
            if (i % 10 != 9) sight.add(i % 3 == 1 ? other : view, glm::radians(4.0));
            if (i % 3 == 1) sight.add(view, 0.0); // two cameras
            const auto expected = activeByBruteForce(*tile, ActiveInSight(view, 2.0, sight));
            for (std::size_t d = 0; d < meshes.size(); ++d)
            {
                meshes[d].setSight(sight);
                const RefineResult result = meshes[d].refine(view, {.errorTolerancePx = 2.0});
                ASSERT_EQ(activeIn(meshes[d].tree()), expected) << driverName(kDrivers[d]) << ", eye " << i;
                EXPECT_EQ(result.errorBoundPx, 2.0);
            }
            EXPECT_LE(drawnErrorPx(*tile, meshes[0].drawn(), view), 2.0 + 1e-3) << i;
            inSight += meshes[0].tree().leafCount();
            allAround += around.refine(view, {.errorTolerancePx = 2.0}).leaves;
        }
        for (const RoamMesh& mesh : meshes)
            EXPECT_TRUE(mesh.isConforming());
        EXPECT_LT(3 * inSight, 2 * allAround);
    }
}

TEST(DriversInSight, AreCoarseBehindSoThatTheErrorThereIsBeyondTheTolerance)
{
    const auto tile = tileOf(false, false);
    Random random(8);
    double worstPx = 0.0;
    for (int i = 0; i < 20; ++i)
    {
        viewlod::Sight elsewhere;
        const viewlod::ViewState view = anyTurn(tile->tile, random);
        viewlod::ViewState turned = anyTurn(tile->tile, random);
        turned.frustum = viewlod::Frustum(turned.clipFromWorld);
        elsewhere.add(turned, 0.0);
        RoamMesh mesh(tile);
        mesh.setSight(elsewhere);
        mesh.refine(view, {.errorTolerancePx = 2.0});
        worstPx = std::max(worstPx, drawnErrorPx(*tile, mesh.drawn(), view));
    }
    EXPECT_GT(worstPx, 20.0);
}

TEST(DriversInSight, KeepACeilingOfWhatIsSeen)
{
    const auto tile = tileOf(false, false);
    Random random(12);
    std::vector<RoamMesh> meshes;
    for (const Driver driver : kDrivers)
        meshes.emplace_back(tile, driver);
    int finer = 0;
    for (int i = 0; i < 60; ++i)
    {
        const viewlod::ViewState view = anyTurn(tile->tile, random);
        viewlod::Sight sight;
        sight.add(view, 0.0);
        RoamMesh around(tile);
        const viewlod::Budget budget{.errorTolerancePx = 0.2, .maxTriangles = 700};
        const double aroundPx = around.refine(view, budget).tolerancePx;
        for (RoamMesh& mesh : meshes)
        {
            mesh.setSight(sight);
            const RefineResult result = mesh.refine(view, budget);
            EXPECT_LE(result.leaves, 700u);
            EXPECT_LE(result.tolerancePx, 1.02 * aroundPx);
            finer += result.tolerancePx < 0.7 * aroundPx ? 1 : 0;
            EXPECT_LE(drawnErrorPx(*tile, mesh.drawn(), view), result.tolerancePx + 1e-3);
        }
    }
    EXPECT_GT(finer, 60) << "of 180";
}

TEST(QueueDriver, ComputesNothingWhileNothingChanges)
{
    const auto tile = tileOf(true, false);
    RoamMesh queue(tile, Driver::queue), walk(tile, Driver::walk);
    Random random(3);
    for (int i = 0; i < 10; ++i)
    {
        const auto view = anyView(tile->tile, random);
        EXPECT_GT(queue.refine(view, {.errorTolerancePx = 2.0}).checks, 0u);
        EXPECT_EQ(queue.refine(view, {.errorTolerancePx = 2.0}).checks, 0u) << "the queues are kept";
        walk.refine(view, {.errorTolerancePx = 2.0});
        EXPECT_GT(walk.refine(view, {.errorTolerancePx = 2.0}).checks, 0u) << "the paper's loop visits all";
        EXPECT_GT(queue.refine(view, {.errorTolerancePx = 1.9}).checks, 0u) << "another tolerance";
    }
}

class Slices : public testing::Test
{
protected:
    static viewlod::Budget sliceOf(double us)
    {
        return {.errorTolerancePx = 1.0, .maxTimeUs = us, .clock = viewlod::Budget::Clock::modelled};
    }

    const std::shared_ptr<const RoamTile> tile = tileOf(true, false);
    Random random{9};
};

TEST_F(Slices, LeaveAValidMeshAndFinishInLaterFrames)
{
    RoamMesh mesh(tile);
    int sliced = 0;
    for (int eye = 0; eye < 20; ++eye)
    {
        const auto view = anyView(tile->tile, random);
        double boundPx = std::numeric_limits<double>::infinity();
        for (int frame = 0;; ++frame)
        {
            ASSERT_LT(frame, 2000) << "does not come to an end";
            const RefineResult result = mesh.refine(view, sliceOf(60.0));
            ASSERT_TRUE(mesh.isConforming());
            // One operation may end past the slice: a forced chain has some tens of triangles.
            const double spentUs = result.checks * viewlod::Slice::kCheckUs +
                                   (result.splits + result.merges) * viewlod::Slice::kChangeUs;
            ASSERT_LE(spentUs, 60.0 + 4000.0 * viewlod::Slice::kChangeUs);
            ASSERT_GE(result.errorBoundPx, 1.0);
            boundPx = result.errorBoundPx;
            if (!result.sliceBound) break;
            ++sliced;
        }
        EXPECT_EQ(boundPx, 1.0);
        ASSERT_EQ(activeIn(mesh.tree()), activeByBruteForce(*tile, ActiveForEye(view, 1.0)));
    }
    EXPECT_GT(sliced, 100) << "no slice was ever used up";
}

TEST_F(Slices, FollowAnEyeThatDoesNotWait)
{
    RoamMesh mesh(tile);
    auto view = anyView(tile->tile, random);
    int sliced = 0;
    for (int frame = 0; frame < 400; ++frame)
    {
        view.eyeWorld += glm::dvec3(20.0 * std::cos(frame * 0.01), 20.0 * std::sin(frame * 0.01), 0.0);
        if (frame % 50 == 49) view = anyView(tile->tile, random);
        sliced += mesh.refine(view, sliceOf(20.0)).sliceBound ? 1 : 0;
        ASSERT_TRUE(frame % 10 != 0 || mesh.isConforming());
    }
    EXPECT_GT(sliced, 50);
    mesh.refine(view, {.errorTolerancePx = 1.0}); // what was left over is not forgotten
    EXPECT_EQ(activeIn(mesh.tree()), activeByBruteForce(*tile, ActiveForEye(view, 1.0)));
}

TEST_F(Slices, OfModelledTimeAreTheSameTwice)
{
    RoamMesh one(tile), other(tile);
    for (int frame = 0; frame < 100; ++frame)
    {
        const auto view = anyView(tile->tile, random);
        const RefineResult a = one.refine(view, sliceOf(25.0)), b = other.refine(view, sliceOf(25.0));
        ASSERT_EQ(std::tie(a.leaves, a.splits, a.merges, a.checks),
                  std::tie(b.leaves, b.splits, b.merges, b.checks));
        ASSERT_EQ(leafSet(one.tree()), leafSet(other.tree()));
    }
}

TEST_F(Slices, KeepTheTriangleCeilingToo)
{
    RoamMesh mesh(tile);
    for (int frame = 0; frame < 200; ++frame)
    {
        const auto view = anyView(tile->tile, random);
        viewlod::Budget budget = sliceOf(40.0);
        budget.errorTolerancePx = 0.3;
        budget.maxTriangles = 900;
        for (int again = 0; again < 3; ++again)
        {
            const RefineResult result = mesh.refine(view, budget);
            ASSERT_LE(result.leaves, 900u) << "frame " << frame;
            ASSERT_TRUE(mesh.isConforming());
        }
    }
}

} // namespace
