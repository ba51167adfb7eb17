// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <gtest/gtest.h>

#include <osg/TriangleFunctor>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>
#include <osgUtil/Statistics>

#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include <osgTerrainROAM/RoamTerrain>

#include "HandCull.h"
#include "SyntheticField.h"
#include "view/ClippedTriangles.h"

namespace
{

using osgTerrainROAM::RoamDrawable;
using osgTerrainROAM::RoamTerrain;

constexpr int kFunctorColumns = 200;
constexpr int kFunctorRows = 150;
constexpr double kSpacingM = 30.0;

osg::ref_ptr<RoamTerrain> terrainOf()
{
    return new RoamTerrain(
        testsupport::planarTile(testsupport::hills(kFunctorColumns, kFunctorRows, kSpacingM)), nullptr);
}

/// Area in the ground plane, and how far the triangles reach.
struct Ground
{
    double area2 = 0.0;
    std::uint64_t downward = 0;
    osg::BoundingBox box;

    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        const double cross = (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
        if (cross < 0.0) ++downward;
        area2 += cross;
        for (const osg::Vec3& p : {a, b, c})
            box.expandBy(p);
    }
};

osg::TriangleFunctor<Ground> groundOf(osg::Drawable& drawable)
{
    osg::TriangleFunctor<Ground> ground;
    drawable.accept(ground);
    return ground;
}

} // namespace

TEST(RoamDrawableFunctor, CoversExactlyTheDataWithUpwardTriangles)
{
    const auto terrain = terrainOf();
    const auto before = groundOf(*terrain->drawable());
    handcull::cull(*terrain, *handcull::cameraAt({3000, 300, 900}, {3000, 4000, 500}), 1);
    const auto after = groundOf(*terrain->drawable());
    ASSERT_TRUE(terrain->drawable()->setPatchExponent(4));
    const auto patched = groundOf(*terrain->drawable());
    for (const auto* ground : {&before, &after, &patched})
    {
        EXPECT_NEAR(ground->area2 / 2.0, (kFunctorColumns - 1) * (kFunctorRows - 1) * kSpacingM * kSpacingM,
                    1.0);
        EXPECT_EQ(ground->downward, 0u);
        EXPECT_FLOAT_EQ(ground->box.xMax(), (kFunctorColumns - 1) * kSpacingM)
            << "clipped at the data's edge";
        EXPECT_FLOAT_EQ(ground->box.yMax(), (kFunctorRows - 1) * kSpacingM);
    }
}

TEST(RoamDrawableFunctor, AMissingRangeShowsInTheArea)
{
    // The mutation for the test above: one region less.
    osgTerrainROAM::core::RoamMesh mesh(
        testsupport::planarTile(testsupport::hills(kFunctorColumns, kFunctorRows, kSpacingM)));
    mesh.refine(1.0);
    std::vector<osgTerrainROAM::core::IndexRange> ranges;
    for (std::uint32_t i = 0; i < mesh.tree().leaves().regionCount(); ++i)
        mesh.tree().leaves().appendRanges(i, ranges);
    ranges.erase(ranges.begin() + static_cast<std::ptrdiff_t>(ranges.size() / 2));
    osg::TriangleFunctor<Ground> ground;
    osgTerrainROAM::clippedTriangles(mesh.tile().tile, mesh.drawn(ranges)).accept(ground);
    EXPECT_GT(
        std::abs(ground.area2 / 2.0 - (kFunctorColumns - 1) * (kFunctorRows - 1) * kSpacingM * kSpacingM),
        100.0);
}

TEST(RoamDrawableFunctor, BoundsHoldEveryTriangleTightly)
{
    const auto terrain = terrainOf();
    ASSERT_TRUE(terrain->drawable()->setDefaultErrorM(0.0));
    const auto ground = groundOf(*terrain->drawable());
    const osg::BoundingBox& box = terrain->drawable()->getBoundingBox();
    for (unsigned int i = 0; i < 8; ++i)
        EXPECT_TRUE(box.contains(ground.box.corner(i)));
    EXPECT_LT(box.zMax() - ground.box.zMax(), 0.1);
    EXPECT_LT(ground.box.zMin() - box.zMin(), 0.1);
    EXPECT_TRUE(terrain->getBound().valid());
}

TEST(RoamDrawableFunctor, IntersectionsLieOnTheSurface)
{
    const auto terrain = terrainOf();
    ASSERT_TRUE(terrain->drawable()->setDefaultErrorM(0.0));
    testsupport::Random random(5);
    for (int i = 0; i < 20; ++i)
    {
        const double x = random.unit() * (kFunctorColumns - 1) * kSpacingM;
        const double y = random.unit() * (kFunctorRows - 1) * kSpacingM;
        const osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
            new osgUtil::LineSegmentIntersector(osg::Vec3d(x, y, 5000), osg::Vec3d(x, y, -5000));
        osgUtil::IntersectionVisitor visitor(segment);
        terrain->accept(visitor);
        ASSERT_TRUE(segment->containsIntersections());
        const auto expected = osgTerrainROAM::core::groundAt(terrain->tile()->tile, x, y);
        ASSERT_TRUE(expected);
        EXPECT_NEAR(segment->getFirstIntersection().getWorldIntersectPoint().z(), expected->position.z, 0.01);
    }
}

TEST(RoamDrawableFunctor, NothingIsHitBeyondTheData)
{
    const auto terrain = terrainOf();
    const double x = (kFunctorColumns + 20) * kSpacingM;
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> segment =
        new osgUtil::LineSegmentIntersector(osg::Vec3d(x, 900, 5000), osg::Vec3d(x, 900, -5000));
    osgUtil::IntersectionVisitor visitor(segment);
    terrain->accept(visitor);
    EXPECT_FALSE(segment->containsIntersections());
}

TEST(RoamDrawableFunctor, StatisticsSeeTriangles)
{
    const auto terrain = terrainOf();
    osgUtil::StatsVisitor visitor;
    terrain->accept(visitor);
    visitor.totalUpStats();
    EXPECT_GT(visitor._uniqueStats.getPrimitiveCountMap().at(GL_TRIANGLES), 1000u);
}

TEST(RoamDrawableFunctor, ACopySharesTheTileAndHasViewsOfItsOwn)
{
    const auto terrain = terrainOf();
    handcull::cull(*terrain, *handcull::cameraAt({3000, 300, 900}, {3000, 4000, 500}), 1);
    const osg::ref_ptr<RoamDrawable> copy =
        static_cast<RoamDrawable*>(terrain->drawable()->clone(osg::CopyOp::DEEP_COPY_ALL));
    EXPECT_EQ(copy->tile(), terrain->tile());
    EXPECT_TRUE(copy->statistics().empty());
    EXPECT_EQ(terrain->statistics().size(), 1u);
}
