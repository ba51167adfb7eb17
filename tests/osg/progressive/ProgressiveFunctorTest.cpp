// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/ComputeBoundsVisitor>
#include <osg/TriangleIndexFunctor>
#include <osgUtil/IntersectionVisitor>
#include <osgUtil/LineSegmentIntersector>

#include <osgPMObjects/MakeProgressive>
#include <osgPMObjects/ProgressiveNode>

#include "HandCull.h"
#include "ProgressiveSubject.h"

namespace
{

using namespace progressive;
using handcull::cameraAt;
using handcull::cull;

/// A sheet some 10⁷ m away, where floats have a step of a metre.
Subject sheetFarAway()
{
    core::Mesh mesh = testsupport::waves(24, 18);
    for (glm::dvec3& p : mesh.positions)
        p += glm::dvec3(4.1e6, -7.3e6, 1.7e6);
    return subjectOf(std::move(mesh));
}

osg::BoundingBox boundsOf(osg::Node& node)
{
    osg::ComputeBoundsVisitor visitor;
    node.accept(visitor);
    return visitor.getBoundingBox();
}

struct IndexCount
{
    std::size_t triangles = 0;
    unsigned largest = 0;
    void operator()(unsigned a, unsigned b, unsigned c)
    {
        ++triangles;
        largest = std::max({largest, a, b, c});
    }
};

std::size_t hitsBelow(osg::Node& node, const osg::Vec3d& from)
{
    const osg::ref_ptr<osgUtil::LineSegmentIntersector> ray =
        new osgUtil::LineSegmentIntersector(from, from - osg::Vec3d(0, 0, 100));
    osgUtil::IntersectionVisitor visitor(ray);
    node.accept(visitor);
    return ray->getIntersections().size();
}

} // namespace

TEST(ProgressiveFunctors, SeeTheFinestLevelBeforeAnybodyHasLooked)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    EXPECT_EQ(trianglesOf(std::vector{node->drawable()}), trianglesOf(subject.mesh));
}

TEST(ProgressiveFunctors, SeeTheLevelThatIsDrawn)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    const auto camera = cameraAt({8.0, -200.0, 3.0}, {8.0, 0.0, 0.0});
    const auto culled = cull(*node, *camera, 1);
    EXPECT_LT(culled.triangles(), subject.mesh.faces.size());
    EXPECT_EQ(trianglesOf(std::vector{node->drawable()}), trianglesOf(culled.drawables));
    osg::TriangleIndexFunctor<IndexCount> indices;
    node->drawable()->accept(indices);
    EXPECT_EQ(indices.triangles, culled.triangles());
    EXPECT_LT(indices.largest, subject.shape->vertices().size());
}

TEST(ProgressiveFunctors, ARayHitsWhatIsDrawn)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    EXPECT_EQ(hitsBelow(*node, {12.2, 6.3, 50.0}), 1u);
    EXPECT_EQ(hitsBelow(*node, {2.03, 0.07, 50.0}), 2u);
    EXPECT_EQ(hitsBelow(*node, {0.03, 0.07, 50.0}), 0u) << "the hole of the torus";
}

TEST(ProgressiveBounds, AreThoseOfAllVertices)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    osg::BoundingBox expected;
    for (const glm::dvec3& p : subject.mesh.positions)
        expected.expandBy(osg::Vec3(osg::Vec3d(p.x, p.y, p.z)));
    const osg::BoundingBox box = boundsOf(*node);
    EXPECT_EQ(box._min, expected._min);
    EXPECT_EQ(box._max, expected._max);
    const core::BoundingSphere& sphere = subject.shape->sphere();
    for (const glm::dvec3& p : subject.mesh.positions)
        EXPECT_LE(glm::distance(p, sphere.centre), sphere.radius * (1.0 + 1e-6));
    EXPECT_GT(node->getBound().radius(), 0.9 * sphere.radius);
}

TEST(ProgressiveBounds, OfAGroupHoldItsFacesAtEveryLevel)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(subject.shape);
    const auto camera = cameraAt({8.0, -60.0, 3.0}, {8.0, 0.0, 0.0});
    for (std::uint32_t steps = 0; steps <= subject.sequence.steps.size(); steps += 20)
    {
        EXPECT_TRUE(drawable->setSteps(steps));
        for (const auto& part : cull(*drawable, *camera, steps + 1).drawables)
            for (const SeenTriangle& triangle : trianglesOf(std::vector{part}))
                for (const auto& corner : triangle)
                    EXPECT_TRUE(part->getBoundingBox().contains({corner[0], corner[1], corner[2]}));
    }
}

TEST(ProgressiveOrigin, KeepsTheDigitsOfWhatLiesFarAway)
{
    const Subject subject = sheetFarAway();
    const osg::Vec3d origin = subject.shape->origin();
    EXPECT_GT(origin.length(), 8e6);
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    EXPECT_EQ(trianglesOf(std::vector{node->drawable()}), trianglesOf(subject.mesh, origin));
    const osg::Vec3d centre = node->getBound().center();
    EXPECT_LT((centre - origin).length(), 1.0);
    const auto camera = cameraAt(centre + osg::Vec3d(0, -40, 10), centre);
    const auto culled = cull(*node, *camera, 1);
    ASSERT_EQ(culled.drawables.size(), 1u);
    EXPECT_LE(node->statistics()[0].steps, subject.sequence.steps.size() / 2) << "the eye is near";
    EXPECT_EQ(hitsBelow(*node, centre + osg::Vec3d(0.3, 0.2, 50.0)), 1u);
}

TEST(ProgressiveCopies, ShareTheShapeAndHaveViewGroupsOfTheirOwn)
{
    const Subject subject = torusAndSheet();
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject.shape);
    node->addChild(new osg::Group);
    core::SelectionSettings settings;
    settings.tolerancePx = 3.0;
    ASSERT_TRUE(node->setSelection(settings));
    const auto camera = cameraAt({8.0, -200.0, 3.0}, {8.0, 0.0, 0.0});
    const std::uint64_t triangles = cull(*node, *camera, 1).triangles();
    for (const auto flags : {osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL})
    {
        const osg::ref_ptr<ProgressiveNode> copy =
            dynamic_cast<ProgressiveNode*>(node->clone(osg::CopyOp(flags)));
        ASSERT_TRUE(copy);
        EXPECT_EQ(copy->shape(), node->shape());
        EXPECT_NE(copy->drawable(), node->drawable());
        EXPECT_EQ(copy->getNumChildren(), 2u);
        EXPECT_EQ(copy->getChild(0), copy->drawable());
        EXPECT_TRUE(copy->statistics().empty());
        EXPECT_EQ(cull(*copy, *camera, 1).triangles(), triangles) << "settings go along";
    }
    const Subject away = sheetFarAway();
    const osg::ref_ptr<ProgressiveNode> placed = new ProgressiveNode(away.shape);
    const osg::ref_ptr<ProgressiveNode> copy = new ProgressiveNode(*placed);
    EXPECT_EQ(copy->getNumChildren(), 1u);
    EXPECT_EQ(boundsOf(*copy).center(), boundsOf(*placed).center());
}

TEST(ProgressiveCopies, OfNothingAreNothing)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode;
    const osg::ref_ptr<ProgressiveNode> copy = new ProgressiveNode(*node);
    EXPECT_FALSE(copy->shape());
    EXPECT_TRUE(copy->statistics().empty());
    EXPECT_TRUE(cull(*copy, *cameraAt({0, -5, 0}, {0, 0, 0}), 1).drawables.empty());
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable;
    EXPECT_TRUE(cull(*drawable, *cameraAt({0, -5, 0}, {0, 0, 0}), 1).drawables.empty());
}
