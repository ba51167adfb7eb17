// SPDX-License-Identifier: Apache-2.0
#include <cmath>

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

TEST(CullFacts, AShadowCameraChoosesDetailByThePixelsOfItsMainCamera)
{
    const auto pixelsIn = [](osg::Transform::ReferenceFrame frame)
    {
        NestedCull cull(frame);
        cull.main->setViewport(0, 0, 800, 600);
        cull.main->setProjectionMatrixAsPerspective(60.0, 4.0 / 3.0, 1.0, 100.0);
        cull.visitor->pushViewport(new osg::Viewport(0, 0, 64, 64));
        cull.visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrixd::ortho(-32, 32, -32, 32, -9, 9)));
        cull.visitor->pushModelViewMatrix(new osg::RefMatrix, osg::Transform::ABSOLUTE_RF);
        const double pixels = detailViewOf(*cull.visitor).pixelsPerTangent;
        cull.visitor->popModelViewMatrix();
        cull.visitor->popProjectionMatrix();
        cull.visitor->popViewport();
        return pixels;
    };
    EXPECT_NEAR(pixelsIn(osg::Transform::ABSOLUTE_RF_INHERIT_VIEWPOINT), 300.0 / std::tan(osg::PI / 6.0),
                1e-9);
    EXPECT_NEAR(pixelsIn(osg::Transform::ABSOLUTE_RF), 1.0, 1e-9) << "its own: a pixel a metre";
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
