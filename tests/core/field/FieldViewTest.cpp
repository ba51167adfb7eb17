// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>

#include <gtest/gtest.h>

#include "FieldScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::FieldSubject;

/// Returns the x coordinate and the rung of each instance, sorted.
std::vector<std::pair<float, std::uint32_t>> rungsByX(const FieldDrawList& drawList)
{
    std::vector<std::pair<float, std::uint32_t>> all;
    for (const FieldRun& run : drawList.runs)
        for (std::uint32_t i = run.first; i < run.first + run.count; ++i)
            all.emplace_back(drawList.instances[i].positionAndScale[0], run.rung);
    std::sort(all.begin(), all.end());
    return all;
}

FieldModel modelWith(SelectionMethod method)
{
    const FieldSubject& subject = FieldSubject::torus();
    FieldModel model = subject.model();
    SelectionSettings& settings = model.selection;
    settings.method = method;
    settings.continuousBand = kDefaultBand;
    settings.areaRows = AreaRows::halving(subject.table);
    const std::uint32_t most = subject.table.mostSteps();
    settings.ranges = {{30.0, 90.0, 250.0}, {0, most / 2, most * 3 / 4, most * 9 / 10}};
    settings.overlappingRanges = OverlappingRanges::around(settings.ranges);
    return model;
}

TEST(FieldView, DrawsEachObjectInSightOnceOnTheRungOfItsRule)
{
    for (const auto method :
         {SelectionMethod::ranges, SelectionMethod::overlappingRanges, SelectionMethod::boxArea,
          SelectionMethod::sphereArea, SelectionMethod::ellipsoidArea, SelectionMethod::facingArea,
          SelectionMethod::continuous, SelectionMethod::screenError})
    {
        const Field field = testsupport::scatteredField({modelWith(method)}, 1500, 300.0);
        const auto view = testsupport::viewTo({0.0, -320.0, 20.0}, {0.0, 0.0, 0.0});
        FieldView memory(field);
        const FieldDrawList drawList = memory.update(testsupport::cameraFrom(view, 1));
        EXPECT_EQ(drawList.instances.size(), drawList.visible);
        EXPECT_EQ(drawList.drawn, drawList.visible);
        EXPECT_EQ(drawList.selection.all().objects, drawList.visible);
        std::vector<std::pair<float, std::uint32_t>> expected;
        std::uint64_t triangles = 0;
        const LevelSelector selector(SelectionView::from(view));
        for (std::uint32_t i = 0; i < field.objects().size(); ++i)
        {
            const BoundingSphere& sphere = field.spheres()[i];
            if (view.frustum.classify(sphere.centre, sphere.radius, 0x0F).outside) continue;
            HeldLevel held;
            const Selection selection = selector.select(field.selectable(i, 1.0), held);
            const std::uint32_t rung = FieldSubject::torus().ladder.rungOf(selection.steps);
            EXPECT_EQ(FieldSubject::torus().ladder.rungs[rung].steps, selection.steps) << "can be drawn";
            triangles += FieldSubject::torus().ladder.rungs[rung].faces;
            expected.emplace_back(static_cast<float>(field.objects()[i].position.x - view.eyeWorld.x), rung);
        }
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(rungsByX(drawList), expected) << nameOf(method);
        EXPECT_EQ(drawList.triangles, triangles);
        EXPECT_EQ(drawList.selection.all().triangles, triangles) << "what is counted is what is drawn";
        ASSERT_GT(drawList.runs.size(), 3u) << "several levels";
    }
}

/// The distance of each object varies by ±5 %, a hundred times.
TEST(FieldView, NeverSwitchesTwiceWhileTheEyeTrembles)
{
    for (const auto method :
         {SelectionMethod::overlappingRanges, SelectionMethod::boxArea, SelectionMethod::sphereArea,
          SelectionMethod::ellipsoidArea, SelectionMethod::facingArea, SelectionMethod::continuous,
          SelectionMethod::screenError, SelectionMethod::ranges})
    {
        int worst = 0;
        for (double middle = 20.0; middle < 400.0; middle *= 1.03)
        {
            const Field field({modelWith(method)}, {FieldObject{}});
            FieldView memory(field);
            std::uint64_t frame = 0;
            worst = std::max(
                worst, testsupport::switchesWhileTrembling(
                           middle, 0.05, 4,
                           [&](double distance)
                           {
                               const auto view = testsupport::viewTo({0.0, -distance, 0.0}, {0.0, 0.0, 0.0});
                               return memory.update(testsupport::cameraFrom(view, ++frame)).runs.front().rung;
                           }));
        }
        if (method == SelectionMethod::ranges)
        {
            EXPECT_GT(worst, 1) << "the control, without hysteresis, flips";
        }
        else
        {
            EXPECT_LE(worst, 1) << nameOf(method);
        }
    }
}

/// An object seen from far away, then after one frame from near by.
TEST(FieldView, SettlesAtOnceWhereTheEyeHasJumpedTo)
{
    FieldModel model = modelWith(SelectionMethod::continuous);
    model.switching.method = SwitchMethod::geomorph;
    const Field field({model}, {FieldObject{}});
    const auto switchingAfter = [&](double fromM, double toM)
    {
        FieldView memory(field);
        std::uint32_t switching = 0;
        for (std::uint64_t frame = 1; frame <= 2; ++frame)
        {
            const double distanceM = frame == 1 ? fromM : toM;
            FieldCamera camera =
                testsupport::cameraFrom(testsupport::viewTo({0.0, -distanceM, 0.0}, {0.0, 0.0, 0.0}), frame);
            camera.stepS = 0.05F;
            switching = memory.update(camera).switching;
        }
        return switching;
    };
    EXPECT_EQ(switchingAfter(400.0, 40.0), 0u);
    EXPECT_EQ(switchingAfter(40.0, 400.0), 0u);
    EXPECT_EQ(switchingAfter(400.0, 300.0), 1u) << "the control: one that comes nearer goes over gradually";
}

TEST(FieldView, KeepsWithinTheBudget)
{
    const Field field = testsupport::scatteredField({modelWith(SelectionMethod::budget)}, 1500, 300.0);
    FieldView memory(field);
    std::uint64_t least = ~std::uint64_t{0}, most = 0;
    for (std::uint64_t frame = 1; frame <= 40; ++frame)
    {
        const double y = -400.0 + 10.0 * static_cast<double>(frame);
        FieldCamera camera =
            testsupport::cameraFrom(testsupport::viewTo({0.0, y, 30.0}, {0.0, y + 100.0, 0.0}), frame);
        camera.budget.budget = 60000;
        const FieldDrawList drawList = memory.update(camera);
        ASSERT_LE(drawList.triangles, 60000u) << frame;
        EXPECT_TRUE(drawList.selection.budget.fits);
        least = std::min(least, drawList.triangles);
        most = std::max(most, drawList.triangles);
    }
    EXPECT_GT(most, 55000u) << "and uses it";
}

TEST(FieldView, NeitherBudgetNorRuleLeavesFewerThanTheLeastFaces)
{
    const auto fewest = [](SelectionMethod method, std::uint32_t leastFaces)
    {
        FieldModel model = modelWith(method);
        model.selection.tolerancePx = method == SelectionMethod::budget ? 1.0 : 1e6;
        model.selection.leastFaces = leastFaces;
        const Field field = testsupport::scatteredField({model}, 300, 300.0);
        FieldView memory(field);
        FieldCamera camera =
            testsupport::cameraFrom(testsupport::viewTo({0.0, -400.0, 30.0}, {0.0, 0.0, 0.0}), 1);
        camera.budget.budget = 1;
        std::uint32_t faces = model.ladder->rungs.front().faces;
        for (const FieldRun& run : memory.update(camera).runs)
            faces = std::min(faces, model.ladder->rungs[run.rung].faces);
        return faces;
    };
    for (const SelectionMethod method : {SelectionMethod::budget, SelectionMethod::screenError})
    {
        EXPECT_LT(fewest(method, 0), 24u) << nameOf(method);
        EXPECT_GE(fewest(method, 24), 24u) << nameOf(method);
        EXPECT_LT(fewest(method, 24), 48u) << nameOf(method) << ": but not many more";
    }
}

/// Cameras that share an eye get the same levels, whichever is updated first.
TEST(FieldView, ShowsAnotherCameraOfTheEyeTheSame)
{
    FieldModel model = modelWith(SelectionMethod::screenError);
    model.switching = {SwitchMethod::blend, BlendProfile::cross, 0.5f, 0.0f};
    const Field field = testsupport::scatteredField({model}, 800, 200.0);
    FieldView memory(field);
    FieldDrawList first, second;
    for (std::uint64_t frame = 1; frame <= 30; ++frame)
    {
        const double y = -300.0 + 4.0 * static_cast<double>(frame);
        const auto camera =
            testsupport::cameraFrom(testsupport::viewTo({0.0, y, 30.0}, {0.0, y + 100.0, 0.0}), frame);
        first = memory.update(camera);
        second = memory.update(camera);
        ASSERT_EQ(rungsByX(first), rungsByX(second));
        ASSERT_EQ(std::memcmp(first.instances.data(), second.instances.data(),
                              first.instances.size() * sizeof(InstanceAttributes)),
                  0)
            << "time has gone on twice in frame " << frame;
    }
    EXPECT_GT(first.switching, 0u);
}

TEST(FieldView, LendsWhatItChoseToTheCameraOfAShadow)
{
    const Field field = testsupport::scatteredField({modelWith(SelectionMethod::budget)}, 1500, 300.0);
    FieldView memory(field), twin(field);
    for (std::uint64_t frame = 1; frame <= 20; ++frame)
    {
        const double y = -400.0 + 10.0 * static_cast<double>(frame);
        FieldCamera camera =
            testsupport::cameraFrom(testsupport::viewTo({0.0, y, 30.0}, {0.0, y + 100.0, 0.0}), frame);
        camera.budget.budget = 60000;
        const FieldDrawList drawList = memory.update(camera);
        ASSERT_EQ(rungsByX(twin.update(camera)), rungsByX(drawList)) << "lending has changed something";
        FieldCamera borrower = camera;
        EXPECT_EQ(rungsByX(memory.lend(borrower)), rungsByX(drawList));
        borrower.frustum = testsupport::viewTo({0.0, 0.0, 2000.0}, {0.0, 0.0, 0.0}).frustum;
        const FieldDrawList whole = memory.lend(borrower);
        EXPECT_EQ(whole.drawn, field.objects().size()) << "behind the eye, too";
        const auto all = rungsByX(whole), chosen = rungsByX(drawList);
        EXPECT_TRUE(std::includes(all.begin(), all.end(), chosen.begin(), chosen.end())) << frame;

        // Parallel rays of 1 m: no more triangles than pixels ask for, and what is smaller than a pixel is
        // left out.
        const FieldDrawList coarse = memory.lend(borrower, 1.0);
        EXPECT_LT(coarse.triangles, whole.triangles / 2);
        EXPECT_GT(coarse.drawn, 0u);
        EXPECT_EQ(memory.lend(borrower, 1000.0).drawn, 0u);
    }
}

TEST(FieldView, ForgetsWhatWasOutOfSight)
{
    FieldModel model = modelWith(SelectionMethod::screenError);
    model.switching = {SwitchMethod::blend, BlendProfile::cross, 1000.0f, 0.0f};
    const Field field({model}, {FieldObject{}});
    FieldView memory(field);
    const auto at = [&](double distance, std::uint64_t frame) {
        return memory.update(testsupport::cameraFrom(testsupport::viewTo({0.0, -distance, 0.0}, {}), frame));
    };
    at(50.0, 1);
    at(90.0, 2);
    EXPECT_EQ(at(90.0, 3).switching, 1u);
    EXPECT_EQ(at(90.0, 9).switching, 0u) << "nobody saw how it got there";
}

} // namespace
