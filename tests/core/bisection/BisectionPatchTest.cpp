// SPDX-License-Identifier: Apache-2.0
// TINs among the leaves of bintrees.
#include <algorithm>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>

#include "MadeSurfaces.h"
#include "Random.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kPatchLevels = 10;

/// A patch with points by chance that bulge out of the ground like a mushroom: at places three heights.
BisectionPatch mushroom(const BisectionSurface& surface, Bisector carrier, int count = 150)
{
    testsupport::Random random(carrier.node);
    const CornerVertices corners = surface.cornersOf(carrier);
    std::vector<PatchPoint> inside;
    while (static_cast<int>(inside.size()) < count)
    {
        const double y = random.unit(), z = random.unit();
        if (y < 0.02 || z < 0.02 || y + z > 0.98) continue;
        const glm::dvec3 w(1.0 - y - z, y, z);
        const glm::dvec3 flat = w.x * surface.point(corners[0]) + w.y * surface.point(corners[1]) +
                                w.z * surface.point(corners[2]);
        const double inner = 27.0 * w.x * w.y * w.z; // 1 in the middle
        const glm::dvec3 middle =
            (surface.point(corners[0]) + surface.point(corners[1]) + surface.point(corners[2])) / 3.0;
        const double lift = 0.3 * inner, spread = 0.9 * std::sin(3.0 * inner);
        inside.push_back({w, flat + spread * (flat - middle) + glm::dvec3(0.0, 0.0, lift)});
    }
    return makePatch(surface, carrier, inside);
}

std::vector<BisectionPatch> threePatches(const BisectionSurface& surface)
{
    // Two that share a side, and one by itself; of different levels.
    const Bisector first{4, 9}, beside = neighboursOf(surface.mesh(), first).base;
    EXPECT_TRUE(beside.exists());
    return {mushroom(surface, first), mushroom(surface, beside), mushroom(surface, {16, 37}, 60)};
}

std::vector<BisectionView> flightOver()
{
    std::vector<BisectionView> views;
    for (int i = 0; i < 12; ++i)
        views.push_back(
            {{0.2 + 0.15 * i, 0.4 + 0.1 * (i % 4), 0.3 + 2.0 * (i % 3)}, 0.01 + 0.3 * (i % 2), 0.05});
    return views;
}

TEST(BisectionPatch, coversItsCarrierWithALockedBorder)
{
    const BisectionSurface surface = testsupport::madeTin(kPatchLevels);
    for (const BisectionPatch& patch : threePatches(surface))
    {
        EXPECT_EQ(checkPatch(surface, patch), std::nullopt);
        EXPECT_GT(patch.points.size(), patch.border.size() + 50);
    }
}

TEST(BisectionPatch, damageIsFound)
{
    const BisectionSurface surface = testsupport::madeTin(kPatchLevels);
    const BisectionPatch good = mushroom(surface, {4, 9});
    const auto isFound = [&](const auto& damage)
    {
        BisectionPatch bad = good;
        damage(bad);
        return checkPatch(surface, bad).has_value();
    };
    EXPECT_FALSE(isFound([](BisectionPatch&) {}));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.points[2].point.z += 1e-9; }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.points[2].weights.x += 1e-9; }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { std::swap(p.border[1], p.border[2]); }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.border.pop_back(); }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.triangles.pop_back(); }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.triangles.push_back(p.triangles[0]); }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { std::swap(p.triangles[7][0], p.triangles[7][1]); }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.triangles[0][0] = 9999; }));
    EXPECT_TRUE(isFound([](BisectionPatch& p) { p.points.back().weights = {0.9, 0.05, 0.05}; }));
}

TEST(BisectionPatch, patchesAndPlainLeavesAreOneMeshWithinItsTolerance)
{
    const BisectionSurface surface = testsupport::madeTin(kPatchLevels);
    const std::vector<BisectionPatch> patches = threePatches(surface);
    BisectionMesh mesh(surface, patches);
    std::size_t shown = 0, hidden = 0;
    for (const BisectionView& view : flightOver())
    {
        mesh.refine(view);
        const std::vector<DrawnBisector> drawn = mesh.drawn();
        EXPECT_EQ(checkDrawn(surface, drawn), std::nullopt);
        EXPECT_TRUE(mesh.tree().isConforming());
        EXPECT_LE(worstShare(mesh, view), 1.0);
        for (std::uint32_t p = 0; p < patches.size(); ++p)
        {
            ++(mesh.isShown(p) ? shown : hidden);
            const auto own =
                std::ranges::count_if(drawn, [p](const DrawnBisector& t) { return t.patch == p; });
            EXPECT_EQ(static_cast<std::size_t>(own), mesh.isShown(p) ? patches[p].triangles.size() : 0u);
        }
        EXPECT_TRUE(std::ranges::any_of(drawn, [](const DrawnBisector& t) { return t.patch == kNoSide; }));
        BisectionMesh fresh(surface, patches);
        fresh.refine(view);
        EXPECT_EQ(fresh.drawn().size(), drawn.size()) << "whatever came before";
        EXPECT_EQ(fresh.tree().leafCount(), mesh.tree().leafCount());
    }
    EXPECT_GT(shown, 5u);
    EXPECT_GT(hidden, 5u);
}

TEST(BisectionPatch, whileItIsHiddenItsPointsCount) // the control of the bound
{
    const BisectionSurface surface = testsupport::madeTin(kPatchLevels);
    const std::vector<BisectionPatch> patches = threePatches(surface);
    const BisectionView view{{1.0, 0.5, 0.8}, 0.03, 0.05};
    BisectionMesh plain(surface);
    BisectionMesh mesh(surface, patches);
    plain.refine(view);
    mesh.refine(view);
    EXPECT_GT(mesh.drawn().size(), plain.drawn().size());
    BisectionView coarse = view;
    coarse.tolerance = 10.0;
    mesh.refine(coarse);
    EXPECT_FALSE(mesh.isShown(0));
    EXPECT_LE(worstShare(mesh, coarse), 1.0);
    EXPECT_GT(worstShare(mesh, view), 1.0);
}

TEST(BisectionPatch, aBorderThatIsNotLockedCracks) // the control of the check
{
    const BisectionSurface surface = testsupport::madeTin(kPatchLevels);
    std::vector<BisectionPatch> patches{mushroom(surface, {4, 9})};
    const BisectionView view{{0.6, 0.6, 0.4}, 0.005, 0.05};
    BisectionMesh mesh(surface, patches);
    mesh.refine(view);
    ASSERT_TRUE(mesh.isShown(0));
    ASSERT_EQ(checkDrawn(surface, mesh.drawn()), std::nullopt);
    patches[0].border[3] = patches[0].border[4];
    EXPECT_NE(checkDrawn(surface, mesh.drawn()), std::nullopt);
}

} // namespace

} // namespace osgTerrainROAM::core
