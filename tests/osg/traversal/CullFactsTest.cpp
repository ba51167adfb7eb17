// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgUtil/RenderStage>

#include <osgTraversal/CullFacts>

namespace
{

using namespace osgTraversal;

/// A cull of the main camera that has come to a camera nested in it.
struct NestedCull
{
    explicit NestedCull(osg::Transform::ReferenceFrame frame)
    {
        nested->setReferenceFrame(frame);
        mainStage->setCamera(main);
        nestedStage->setCamera(nested);
        visitor->setRenderStage(mainStage);
        visitor->setStateGraph(graph);
        visitor->getRenderStage()->setCamera(main);
        visitor->setCurrentRenderBin(nestedStage);
    }

    osg::ref_ptr<osg::Camera> main = new osg::Camera, nested = new osg::Camera;
    osg::ref_ptr<osgUtil::RenderStage> mainStage = new osgUtil::RenderStage,
                                       nestedStage = new osgUtil::RenderStage;
    osg::ref_ptr<osgUtil::StateGraph> graph = new osgUtil::StateGraph;
    osg::ref_ptr<osgUtil::CullVisitor> visitor = osgUtil::CullVisitor::create();
};

TEST(CullFacts, ShadowAndReflectionCamerasShareTheViewOfTheirMainCamera)
{
    for (const auto frame : {osg::Transform::RELATIVE_RF, osg::Transform::ABSOLUTE_RF_INHERIT_VIEWPOINT})
    {
        NestedCull cull(frame);
        EXPECT_EQ(mainCameraOf(*cull.visitor), cull.main.get()) << frame;
    }
}

TEST(CullFacts, ANestedCameraWithAFrameOfItsOwnLooksForItself)
{
    NestedCull cull(osg::Transform::ABSOLUTE_RF);
    EXPECT_EQ(mainCameraOf(*cull.visitor), nullptr);
}

TEST(CullFacts, ACameraThatIsNotNestedLooksForItself)
{
    NestedCull cull(osg::Transform::RELATIVE_RF);
    cull.visitor->setCurrentRenderBin(cull.mainStage);
    EXPECT_EQ(mainCameraOf(*cull.visitor), nullptr);
}

TEST(CullFacts, TheRoundingOfARotationIsNoScale)
{
    for (int degrees = 0; degrees < 360; ++degrees)
        EXPECT_EQ(eyePerLocal(
                      osg::Matrixd::rotate(osg::DegreesToRadians(degrees + 0.1), osg::Vec3d(1.0, 2.0, 3.0))),
                  1.0);
}

TEST(CullFacts, AScaleIsFoundHoweverTheFrameIsTurned)
{
    const osg::Matrixd turn = osg::Matrixd::rotate(0.7, osg::Vec3d(1.0, 2.0, 3.0));
    EXPECT_NEAR(eyePerLocal(osg::Matrixd::scale(2.5, 2.5, 2.5) * turn), 2.5, 1e-12);
    EXPECT_EQ(eyePerLocal(osg::Matrixd::scale(1.0, 0.0, 1.0)), 1.0) << "without volume";
}

TEST(CullFacts, ATraversalThatNobodyDrawsHasNoContextAndNoFrame)
{
    const osg::ref_ptr<osgUtil::CullVisitor> visitor = osgUtil::CullVisitor::create();
    EXPECT_FALSE(contextIdOf(*visitor));
    EXPECT_EQ(frameOf(*visitor), 0u);
}

} // namespace
