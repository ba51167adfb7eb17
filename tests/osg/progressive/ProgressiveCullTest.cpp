// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osg/MatrixTransform>

#include <osgPMObjects/ProgressiveNode>

#include "HandCull.h"
#include "ProgressiveSubject.h"

namespace
{

using namespace progressive;
using handcull::cameraAt;
using handcull::cull;
using handcull::Culled;

const Subject& subject()
{
    static const Subject made = torusAndSheet();
    return made;
}

/// A camera at a distance from the middle of an object with a radius of some 15.
osg::ref_ptr<osg::Camera> cameraAway(double metres)
{
    return cameraAt({8.0, -metres, 3.0}, {8.0, 0.0, 0.0});
}

std::size_t viewGroupsOf(const ProgressiveNode& node)
{
    return node.statistics().size();
}

} // namespace

TEST(ProgressiveDrawable, DrawsTheTrianglesOfEveryLevelWhateverCameBefore)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(subject().shape);
    const auto camera = cameraAway(40.0);
    const auto most = static_cast<std::uint32_t>(subject().sequence.steps.size());
    unsigned frame = 0;
    for (const std::uint32_t steps : {0u, most / 3, most / 2, 1u, most, most - 5, most / 4, 0u})
    {
        EXPECT_TRUE(drawable->setSteps(steps));
        const Culled culled = cull(*drawable, *camera, ++frame);
        const core::Mesh level = core::meshAfter(subject().mesh, subject().sequence, steps);
        EXPECT_EQ(trianglesOf(culled.drawables), trianglesOf(level)) << steps;
        EXPECT_EQ(culled.triangles(), level.faces.size()) << "holes are no triangles";
        ASSERT_EQ(drawable->statistics().size(), 1u);
        EXPECT_EQ(drawable->statistics()[0].triangles, level.faces.size());
        EXPECT_EQ(drawable->statistics()[0].steps, steps);
    }
}

TEST(ProgressiveDrawable, IsOneDrawableOfTheRenderGraphForEachMaterial)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(subject().shape);
    EXPECT_EQ(cull(*drawable, *cameraAway(40.0), 1).drawables.size(), 2u);
}

TEST(ProgressiveDrawable, MakesNothingNewWhileNothingChanges)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(subject().shape);
    const auto camera = cameraAway(40.0);
    const Culled first = cull(*drawable, *camera, 1), second = cull(*drawable, *camera, 2);
    EXPECT_EQ(first.drawables, second.drawables);
    EXPECT_TRUE(drawable->setSteps(7));
    EXPECT_NE(cull(*drawable, *camera, 3).drawables, first.drawables);
}

TEST(ProgressiveDrawable, IsLeftOutBehindTheCamera)
{
    const osg::ref_ptr<ProgressiveDrawable> drawable = new ProgressiveDrawable(subject().shape);
    const auto camera = cameraAt({8.0, -60.0, 3.0}, {8.0, -900.0, 3.0});
    EXPECT_TRUE(cull(*drawable, *camera, 1).drawables.empty());
}

TEST(ProgressiveDrawable, TellsOsgWhereItsNearAndFarAre)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const auto camera = cameraAway(300.0);
    const Culled culled = cull(*node, *camera, 1, true);
    double fovy, aspect, nearM, farM;
    ASSERT_TRUE(culled.projection.getPerspective(fovy, aspect, nearM, farM));
    EXPECT_GT(nearM, 250.0);
    EXPECT_LT(farM, 350.0);
    EXPECT_GT(culled.drawables.size(), 0u);
}

TEST(ProgressiveNode, IsCoarserFarAwayAndSaysSo)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const auto camera = cameraAway(30.0);
    const std::uint64_t nearby = cull(*node, *camera, 1).triangles();
    camera->setViewMatrixAsLookAt({8.0, -400.0, 3.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    const std::uint64_t away = cull(*node, *camera, 2).triangles();
    EXPECT_LT(away * 3, nearby);
    ASSERT_EQ(viewGroupsOf(*node), 1u) << "a camera that moves takes its view group along";
    const auto statistics = node->statistics()[0];
    EXPECT_EQ(statistics.triangles, away);
    EXPECT_EQ(statistics.frame, 2u);
    EXPECT_EQ(statistics.steps, statistics.selection.steps);
    EXPECT_TRUE(statistics.selection.hasSwitched);
    EXPECT_EQ(statistics.selection.reason, core::SelectionReason::rule);
    EXPECT_GT(statistics.played.steps, 0u);

    node->drawable()->setCullingActive(false); // it is small then
    camera->setViewMatrixAsLookAt({8.0, -9e5, 3.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    cull(*node, *camera, 3);
    EXPECT_EQ(node->statistics()[0].selection.reason, core::SelectionReason::clamped);
}

TEST(ProgressiveNode, KeepsItsScreenErrorWithinTheTolerance)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    for (const double metres : {30.0, 100.0, 300.0, 1000.0})
    {
        cull(*node, *cameraAway(metres), 1);
        const std::uint32_t steps = node->statistics().back().steps;
        const double radius = subject().shape->sphere().radius;
        // 800 × 600 pixels, 46.8° high. Pixels of the corners, which are larger, are left out; that makes the
        // check stricter.
        const double pixels = subject().shape->levels().errors[steps].distance / (metres - radius) * 300.0 /
                              std::tan(osg::DegreesToRadians(23.4));
        EXPECT_LE(pixels, node->selection().tolerancePx) << metres;
    }
}

TEST(ProgressiveNode, ShowsDifferentEyesDifferentLevelsAtOnce)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const auto nearby = cameraAway(30.0), away = cameraAway(500.0);
    for (unsigned frame = 1; frame < 4; ++frame)
    {
        const Culled a = cull(*node, *nearby, frame), b = cull(*node, *away, frame);
        ASSERT_EQ(viewGroupsOf(*node), 2u);
        EXPECT_GT(a.triangles(), 3 * b.triangles());
        EXPECT_EQ(a.triangles(), node->statistics()[0].triangles);
        EXPECT_EQ(b.triangles(), node->statistics()[1].triangles);
    }
}

TEST(ProgressiveNode, ShowsCamerasOfOneEyeTheFinestLevelThatOneOfThemNeeds)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const auto wide = cameraAway(200.0), zoomed = cameraAway(200.0);
    zoomed->setProjectionMatrixAsPerspective(10.0, 800.0 / 600.0, 1.0, 1e6);
    const auto alone = cameraAway(200.0);
    const osg::ref_ptr<ProgressiveNode> another = new ProgressiveNode(subject().shape);
    const std::uint64_t coarse = cull(*another, *alone, 1).triangles();
    for (unsigned frame = 1; frame < 3; ++frame)
    {
        cull(*node, *wide, frame);
        cull(*node, *zoomed, frame);
    }
    ASSERT_EQ(viewGroupsOf(*node), 1u);
    EXPECT_EQ(node->statistics()[0].cameras, 2u);
    const std::uint64_t shared = cull(*node, *wide, 3).triangles();
    EXPECT_GT(shared, coarse);
    EXPECT_EQ(cull(*node, *zoomed, 3).triangles(), shared);
}

TEST(ProgressiveNode, HasALevelOfItsOwnAtEachPlaceWhereItStands)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (const double away : {0.0, 600.0})
    {
        const osg::ref_ptr<osg::MatrixTransform> place =
            new osg::MatrixTransform(osg::Matrixd::translate(0.0, away, 0.0));
        place->addChild(node);
        scene->addChild(place);
    }
    const auto camera = cameraAway(40.0);
    for (unsigned frame = 1; frame < 4; ++frame)
    {
        const Culled culled = cull(*scene, *camera, frame);
        ASSERT_EQ(viewGroupsOf(*node), 2u) << "frame " << frame;
        const auto statistics = node->statistics();
        EXPECT_GT(statistics[0].triangles, 3 * statistics[1].triangles);
        EXPECT_EQ(culled.triangles(), statistics[0].triangles + statistics[1].triangles);
        const bool switched = statistics[0].selection.hasSwitched || statistics[1].selection.hasSwitched;
        EXPECT_FALSE(switched) << "frame " << frame;
    }
}

TEST(ProgressiveNode, IsSeenTheSameTwiceAsLargeAndTwiceAsFarAway)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const osg::ref_ptr<osg::MatrixTransform> larger = new osg::MatrixTransform(osg::Matrixd::scale(2, 2, 2));
    larger->addChild(node);
    const std::uint64_t expected = cull(*node, *cameraAway(150.0), 1).triangles();
    const auto camera = cameraAt({16.0, -300.0, 6.0}, {16.0, 0.0, 0.0});
    EXPECT_EQ(cull(*larger, *camera, 2).triangles(), expected);
}

TEST(ProgressiveNode, ChoosesByPixelsInAParallelProjection)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    std::uint64_t last = 0;
    for (const double halfHeight : {1000.0, 100.0, 10.0})
    {
        const auto camera = cameraAway(100.0);
        camera->setProjectionMatrixAsOrtho(-halfHeight, halfHeight, -halfHeight, halfHeight, 1.0, 1000.0);
        const std::uint64_t triangles = cull(*node, *camera, 1).triangles();
        EXPECT_GT(triangles, last);
        last = triangles;
    }
}

TEST(ProgressiveNode, IsNotDrawnBeyondItsAlphaRange)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    core::SelectionSettings settings;
    settings.alpha = {100.0, 200.0};
    ASSERT_TRUE(node->setSelection(settings));
    const auto camera = cameraAway(300.0);
    EXPECT_TRUE(cull(*node, *camera, 1).drawables.empty());
    ASSERT_EQ(viewGroupsOf(*node), 1u);
    EXPECT_EQ(node->statistics()[0].selection.reason, core::SelectionReason::gone);
    camera->setViewMatrixAsLookAt({8.0, -50.0, 3.0}, {8.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_FALSE(cull(*node, *camera, 2).drawables.empty());
}

TEST(ProgressiveNode, ChoosesByWhateverMethodItIsGiven)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    core::SelectionSettings settings;
    settings.method = core::SelectionMethod::ranges;
    settings.ranges = {{100.0}, {0, 300}};
    ASSERT_TRUE(node->setSelection(settings));
    cull(*node, *cameraAway(50.0), 1);
    EXPECT_EQ(node->statistics().back().steps, 0u);
    cull(*node, *cameraAway(150.0), 2);
    EXPECT_EQ(node->statistics().back().steps, 300u);

    settings.ranges = {{100.0}, {0, 1000000}};
    EXPECT_FALSE(node->setSelection(settings)) << "more steps than there are";
    settings.method = core::SelectionMethod::budget;
    EXPECT_FALSE(node->setSelection(settings));
    EXPECT_EQ(node->selection().method, core::SelectionMethod::ranges) << "what is refused changes nothing";
}

TEST(ProgressiveNode, DropsViewGroupsThatNobodyAsksFor)
{
    const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(subject().shape);
    const auto stays = cameraAway(30.0);
    auto goes = cameraAway(60.0);
    const auto forgets = cameraAway(90.0);
    for (const auto& camera : {stays, goes, forgets})
        cull(*node, *camera, 1);
    EXPECT_EQ(viewGroupsOf(*node), 3u);
    goes = nullptr;
    cull(*node, *stays, 2);
    EXPECT_EQ(viewGroupsOf(*node), 2u) << "a camera is gone";
    for (unsigned frame = 3; frame < 40; ++frame)
        cull(*node, *stays, frame);
    EXPECT_EQ(viewGroupsOf(*node), 1u) << "another has not asked for long";
}
