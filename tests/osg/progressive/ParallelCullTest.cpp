// SPDX-License-Identifier: Apache-2.0
// Objects and fields in parallel projections.
#include <gtest/gtest.h>

#include <osgPMObjects/ProgressiveField>
#include <osgPMObjects/ProgressiveNode>

#include "HandCull.h"
#include "ProgressiveSubject.h"

namespace
{

using namespace progressive;
using core::SelectionMethod;

const Subject& parallelSubject()
{
    static const Subject made = torusAndSheet();
    return made;
}

/// A camera of 800 × 600 pixels, each so many metres wide, at a distance; or a perspective with such pixels
/// at 0.
osg::ref_ptr<osg::Camera> camera(double metresPerPixel, double awayM, bool isParallel = true)
{
    auto made = handcull::cameraAt({8.0, -awayM, 0.3 * awayM}, {8.0, 0.0, 0.0});
    const double x = 400.0 * metresPerPixel, y = 300.0 * metresPerPixel;
    if (isParallel)
        made->setProjectionMatrixAsOrtho(-x, x, -y, y, 1.0, 1e6);
    else
        made->setProjectionMatrixAsFrustum(-x / awayM, x / awayM, -y / awayM, y / awayM, 1.0, 1e6);
    return made;
}

core::SelectionSettings settingsOf(SelectionMethod method)
{
    core::SelectionSettings settings;
    settings.method = method;
    settings.areaRows = core::AreaRows::halving(parallelSubject().shape->levels());
    return settings;
}

constexpr SelectionMethod kByPixels[] = {SelectionMethod::boxArea,    SelectionMethod::sphereArea,
                                         SelectionMethod::facingArea, SelectionMethod::ellipsoidArea,
                                         SelectionMethod::continuous, SelectionMethod::screenError};

/// A kind for each method and for the budget, and three of each kind.
osg::ref_ptr<ProgressiveField> field()
{
    std::vector<FieldKind> kinds;
    std::vector<FieldInstance> instances;
    const auto add = [&](SelectionMethod method)
    {
        FieldKind& kind = kinds.emplace_back();
        kind.shape = parallelSubject().shape;
        kind.selection = settingsOf(method);
        for (int i = 0; i < 3; ++i)
        {
            FieldInstance& instance = instances.emplace_back();
            instance.kind = static_cast<std::uint32_t>(kinds.size() - 1);
            instance.position = {3.0 * i, 5.0 * static_cast<double>(kinds.size()), 0.0};
        }
    };
    for (const SelectionMethod method : kByPixels)
        add(method);
    add(SelectionMethod::budget);
    osg::ref_ptr<ProgressiveField> made = new ProgressiveField;
    EXPECT_TRUE(made->setContents(std::move(kinds), instances));
    return made;
}

FieldViewStatistics looked(ProgressiveField& field, osg::Camera& camera)
{
    handcull::cull(field, camera, 1);
    return field.statistics().at(0);
}

} // namespace

TEST(ParallelProjection, CountsWhatEachMethodDidInAField)
{
    const FieldViewStatistics statistics = looked(*field(), *camera(0.2, 900.0));
    EXPECT_EQ(statistics.visible, 21u);
    for (const SelectionMethod method : kByPixels)
    {
        EXPECT_EQ(statistics.selection.of(method).objects, 3u) << core::nameOf(method);
        EXPECT_GT(statistics.selection.of(method).triangles, 0u) << core::nameOf(method);
        EXPECT_EQ(statistics.selection.of(method).fullArea, 0u) << "nothing is larger for being near";
    }
    EXPECT_EQ(statistics.selection.of(SelectionMethod::budget).objects, 3u);
    EXPECT_EQ(statistics.selection.all().triangles, statistics.triangles);
    EXPECT_EQ(statistics.selection.of(SelectionMethod::ranges).objects, 0u) << "of which there are none";
}

TEST(ParallelProjection, GivesEveryMethodThePixelsThatItHas)
{
    const FieldViewStatistics fine = looked(*field(), *camera(0.05, 900.0)),
                              coarse = looked(*field(), *camera(4.0, 900.0)),
                              fromAfar = looked(*field(), *camera(0.05, 90000.0));
    const auto of = [](const FieldViewStatistics& statistics, SelectionMethod method)
    { return statistics.selection.of(method).triangles; };
    for (const SelectionMethod method : kByPixels)
    {
        EXPECT_GT(of(fine, method), of(coarse, method)) << core::nameOf(method);
        EXPECT_EQ(of(fine, method), of(fromAfar, method)) << core::nameOf(method);
    }
    EXPECT_GE(of(fine, SelectionMethod::budget), of(coarse, SelectionMethod::budget));
    // The control: with the pixels of a perspective the distant one is coarser.
    const auto lens = camera(0.05, 900.0, false);
    const osg::Matrixd projection = lens->getProjectionMatrix();
    const auto farLens = camera(0.05, 90000.0, false);
    farLens->setProjectionMatrix(projection);
    EXPECT_GT(looked(*field(), *lens).triangles, 2 * looked(*field(), *farLens).triangles);
}

TEST(ParallelProjection, HoldsABudget)
{
    const osg::ref_ptr<ProgressiveField> limited = field();
    const auto eye = camera(0.05, 900.0);
    const std::uint64_t before = looked(*limited, *eye).triangles;
    ASSERT_TRUE(limited->setBudget({.budget = before - 100}));
    handcull::cull(*limited, *eye, 2);
    const FieldViewStatistics statistics = limited->statistics().at(0);
    EXPECT_LE(statistics.triangles, before - 100);
    EXPECT_TRUE(statistics.selection.budget.fits);
}

TEST(ParallelProjection, ChoosesForAnObjectAsAPerspectiveFromFarAway)
{
    for (const SelectionMethod method : kByPixels)
    {
        const osg::ref_ptr<ProgressiveNode> node = new ProgressiveNode(parallelSubject().shape);
        ASSERT_TRUE(node->setSelection(settingsOf(method)));
        for (const double pixel : {0.03, 0.11, 0.42})
        {
            const auto steps = [&](bool isParallel)
            {
                const osg::ref_ptr<ProgressiveNode> fresh = new ProgressiveNode(*node);
                handcull::cull(*fresh, *camera(pixel, 9e5, isParallel), 1);
                return static_cast<double>(fresh->statistics().at(0).steps);
            };
            EXPECT_NEAR(steps(true), steps(false), 2.0) << core::nameOf(method) << ' ' << pixel;
        }
    }
}
