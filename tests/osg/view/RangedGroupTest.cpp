// SPDX-License-Identifier: Apache-2.0
#include "scenery/nodes/RangedGroup.h"

#include <gtest/gtest.h>

#include <osg/LOD>
#include <osgUtil/CullVisitor>
#include <osgUtil/RenderStage>

namespace
{

using scenery::RangedGroup;

constexpr double kFarM = 900.0;

/// Counts the traversals that reach it.
struct Content : osg::Node
{
    void traverse(osg::NodeVisitor&) override { ++reached; }
    osg::BoundingSphere computeBound() const override { return {osg::Vec3(), 100.0F}; }
    int reached = 0;
};

/// A camera that looks at a node from a distance, once a frame.
struct Eye
{
    Eye()
    {
        visitor->setStateGraph(graph);
        visitor->setRenderStage(stage);
        visitor->setCurrentRenderBin(stage);
        stage->setCamera(camera);
        visitor->setFrameStamp(stamp);
        camera->setViewport(0, 0, 64, 64);
    }

    /// Whether the content was reached.
    bool sees(osg::Node& node, const Content& content, double distanceM)
    {
        stamp->setFrameNumber(++frame);
        const int before = content.reached;
        visitor->pushViewport(camera->getViewport());
        visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrixd::perspective(60.0, 1.0, 1.0, 1e4)));
        visitor->pushModelViewMatrix(
            new osg::RefMatrix(osg::Matrixd::lookAt(osg::Vec3d(0.0, -distanceM, 0.0), osg::Vec3d(),
                                                    osg::Vec3d(0.0, 0.0, 1.0))),
            osg::Transform::ABSOLUTE_RF);
        node.accept(*visitor);
        visitor->popModelViewMatrix();
        visitor->popProjectionMatrix();
        visitor->popViewport();
        return content.reached > before;
    }

    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    osg::ref_ptr<osgUtil::CullVisitor> visitor = osgUtil::CullVisitor::create();
    unsigned int frame = 0;
};

/// How often what is seen changes while the distance goes to and fro by 5 % about the boundary.
int changesOf(osg::Node& node, const Content& content)
{
    Eye eye;
    bool before = eye.sees(node, content, kFarM);
    int changes = 0;
    for (int i = 0; i < 20; ++i)
    {
        const bool now = eye.sees(node, content, kFarM * (i % 2 == 0 ? 0.95 : 1.05));
        changes += now != before;
        before = now;
    }
    return changes;
}

TEST(RangedGroup, AnEyeThatLingersAtTheBoundaryLetsNothingFlicker)
{
    const osg::ref_ptr<Content> content = new Content;
    const osg::ref_ptr<RangedGroup> ranged = new RangedGroup(kFarM);
    ranged->addChild(content);
    EXPECT_LE(changesOf(*ranged, *content), 1);
    // The control: ranges that do not overlap.
    const osg::ref_ptr<Content> plain = new Content;
    const osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->addChild(plain, 0.0F, static_cast<float>(kFarM));
    EXPECT_GE(changesOf(*lod, *plain), 19);
}

TEST(RangedGroup, EachCameraRemembersItsOwn)
{
    const osg::ref_ptr<Content> content = new Content;
    const osg::ref_ptr<RangedGroup> ranged = new RangedGroup(kFarM);
    ranged->addChild(content);
    Eye near, far;
    EXPECT_TRUE(near.sees(*ranged, *content, 0.5 * kFarM));
    EXPECT_FALSE(far.sees(*ranged, *content, 2.0 * kFarM));
    EXPECT_TRUE(near.sees(*ranged, *content, 1.02 * kFarM)) << "was drawn, so it still is";
    EXPECT_FALSE(far.sees(*ranged, *content, 0.98 * kFarM)) << "was not drawn, so it is not yet";
    EXPECT_FALSE(near.sees(*ranged, *content, 1.2 * kFarM));
    EXPECT_TRUE(far.sees(*ranged, *content, 0.8 * kFarM));
}

} // namespace
