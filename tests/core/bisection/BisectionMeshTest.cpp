// SPDX-License-Identifier: Apache-2.0
#include <set>

#include <gtest/gtest.h>

#include <osgTerrainROAM/core/bisection/BisectionCheck.h>

#include "MadeSurfaces.h"

namespace osgTerrainROAM::core
{

namespace
{

constexpr int kMeshLevels = 10;

/// Eyes on a way around and through a surface of about two units, near and far.
std::vector<BisectionView> flightAround()
{
    std::vector<BisectionView> views;
    for (int i = 0; i < 12; ++i)
    {
        const double turn = 0.7 * i, far = 0.2 + 0.35 * (i % 5);
        views.push_back(
            {{0.5 + far * std::cos(turn), 0.8 + far * std::sin(turn), 1.1 + 0.2 * (i % 3)}, 0.012, 0.05});
    }
    return views;
}

std::vector<BisectionSurface> madeSurfaces()
{
    std::vector<BisectionSurface> surfaces;
    surfaces.push_back(testsupport::madeSphere(kMeshLevels));
    surfaces.push_back(testsupport::madeTin(kMeshLevels));
    surfaces.push_back(testsupport::madeOverhang(kMeshLevels));
    return surfaces;
}

std::uint32_t sameDrawn(const std::vector<DrawnBisector>& a, const std::vector<DrawnBisector>& b)
{
    if (a.size() != b.size()) return 0;
    std::uint32_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        same += a[i].vertices == b[i].vertices && a[i].leaf == b[i].leaf ? 1 : 0;
    return same;
}

TEST(BisectionMesh, noPointIsFartherOffThanItsToleranceOnAnySurface)
{
    for (const BisectionSurface& surface : madeSurfaces())
    {
        BisectionMesh mesh(surface);
        double worst = 0.0;
        for (const BisectionView& view : flightAround())
        {
            mesh.refine(view);
            const std::vector<DrawnBisector> drawn = mesh.drawn();
            EXPECT_EQ(checkDrawn(surface, drawn), std::nullopt);
            EXPECT_TRUE(mesh.tree().isConforming());
            EXPECT_EQ(drawn.size(), mesh.tree().leafCount());
            EXPECT_LT(drawn.size(), (surface.mesh().sides() << kMeshLevels) / 4);
            worst = std::max(worst, worstShare(mesh, view));
            BisectionView sharper = view;
            sharper.tolerance /= 3.0;
            EXPECT_GT(worstShare(mesh, sharper), 1.0) << "the control: a third of it is passed";
        }
        EXPECT_LE(worst, 1.0);
        EXPECT_GT(worst, 0.3) << "it is used";
    }
}

TEST(BisectionMesh, isThatOfAnEmptyOneForEachEye)
{
    for (const BisectionSurface& surface : madeSurfaces())
    {
        BisectionMesh followed(surface);
        const std::vector<BisectionView> views = flightAround();
        for (const BisectionView& view : views)
        {
            followed.refine(view);
            BisectionMesh fresh(surface);
            fresh.refine(view);
            EXPECT_EQ(sameDrawn(followed.drawn(), fresh.drawn()), fresh.drawn().size());
        }
        const BisectionChanges none = followed.refine(views.back());
        EXPECT_EQ(none.split + none.merged, 0u) << "an eye that stands changes nothing";
        const BisectionChanges some = followed.refine(views.front());
        EXPECT_GT(some.split + some.merged, 0u);
    }
}

TEST(BisectionMesh, aSphereStaysClosed)
{
    const BisectionSurface sphere = testsupport::madeSphere(kMeshLevels);
    BisectionMesh mesh(sphere);
    for (const BisectionView& view : flightAround())
    {
        mesh.refine(view);
        std::set<std::uint32_t> vertices;
        const std::vector<DrawnBisector> drawn = mesh.drawn();
        for (const DrawnBisector& t : drawn)
            vertices.insert(t.vertices.begin(), t.vertices.end());
        EXPECT_EQ(2 * vertices.size(), drawn.size() + 4)
            << "Euler: V - E + F = 2, with three sides a triangle";
    }
}

TEST(BisectionMesh, detailIsWhereTheEyeIs)
{
    const BisectionSurface sphere = testsupport::madeSphere(kMeshLevels);
    BisectionMesh mesh(sphere);
    mesh.refine({{0.0, 0.0, 1.3}, 0.012, 0.05});
    std::size_t near = 0, away = 0;
    for (const DrawnBisector& t : mesh.drawn())
    {
        near += mesh.point(t.vertices[0]).z > 0.6 ? 1 : 0;
        away += mesh.point(t.vertices[0]).z < -0.6 ? 1 : 0;
    }
    EXPECT_GT(near, 3 * away);
}

TEST(BisectionMesh, boundsNest)
{
    const BisectionSurface surface = testsupport::madeOverhang(6);
    const BisectionBounds bounds(surface, {});
    std::uint32_t looked = 0;
    for (std::uint32_t side = 0; side < surface.mesh().sides(); ++side)
        for (std::uint32_t node = 2; node < 64; ++node)
        {
            const std::uint32_t own = surface.vertexOf(Bisector{side, node}),
                                above = surface.vertexOf(Bisector{side, node}.parent());
            EXPECT_GE(bounds.error(above), bounds.error(own));
            EXPECT_GE(bounds.radius(above) + 1e-12,
                      glm::distance(surface.point(above), surface.point(own)) + bounds.radius(own));
            ++looked;
        }
    EXPECT_EQ(looked, surface.mesh().sides() * 62);
}

TEST(BisectionMesh, damageOfWhatIsDrawnIsFound)
{
    const BisectionSurface tin = testsupport::madeTin(kMeshLevels);
    BisectionMesh mesh(tin);
    mesh.refine(flightAround()[3]);
    const std::vector<DrawnBisector> good = mesh.drawn();
    ASSERT_EQ(checkDrawn(tin, good), std::nullopt);
    const std::size_t inside = good.size() / 2;
    std::vector<DrawnBisector> bad = good;
    bad.erase(bad.begin() + static_cast<std::ptrdiff_t>(inside));
    EXPECT_NE(checkDrawn(tin, bad), std::nullopt) << "a hole";
    bad = good;
    std::swap(bad[inside].vertices[0], bad[inside].vertices[1]);
    EXPECT_NE(checkDrawn(tin, bad), std::nullopt) << "a turned triangle";
    bad = good;
    bad.push_back(good[inside]);
    EXPECT_NE(checkDrawn(tin, bad), std::nullopt) << "one twice";
    bad = good;
    bad[inside].vertices[0] = bad[inside].vertices[1];
    EXPECT_NE(checkDrawn(tin, bad), std::nullopt);
    bad = good; // one side of a base is split, the other is not
    const DrawnBisector whole = good[inside];
    const std::uint32_t middle = tin.vertexOf(whole.leaf);
    bad[inside].vertices = {whole.vertices[2], whole.vertices[0], middle};
    bad.push_back({{whole.vertices[1], whole.vertices[2], middle}, whole.leaf});
    EXPECT_NE(checkDrawn(tin, bad), std::nullopt) << "a T-junction";
}

} // namespace

} // namespace osgTerrainROAM::core
