// SPDX-License-Identifier: Apache-2.0
// Parallel projections agree with a perspective from far away, for every rule.
#include <numbers>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/BoxArea.h>
#include <osgPMObjects/core/selection/EllipsoidArea.h>
#include <osgPMObjects/core/selection/LevelSelector.h>
#include <osgPMObjects/core/selection/SphereArea.h>

#include "ClosedMeshes.h"
#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

const glm::dvec3 kEye{300.0, -500.0, 400.0};

/// Returns a parallel view from kEye to 0 with 1280 × 720 pixels of the given size.
viewlod::ViewState parallel(double metresPerPixel, const glm::dvec3& eye = kEye)
{
    const double x = 640.0 * metresPerPixel, y = 360.0 * metresPerPixel;
    return viewlod::ViewState::fromMatrices(glm::lookAt(eye, glm::dvec3(0.0), glm::dvec3(0, 0, 1)),
                                            glm::ortho(-x, x, -y, y, 1.0, 1e5), 1280, 720);
}

/// Returns a perspective from far away whose pixels have the same size at 0.
viewlod::ViewState farAway(double metresPerPixel)
{
    constexpr double kAwayM = 1e6;
    const double highDeg = glm::degrees(2.0 * std::atan(360.0 * metresPerPixel / kAwayM));
    return testsupport::viewTo(glm::normalize(kEye) * kAwayM, glm::dvec3(0.0), highDeg);
}

struct ParallelFixture
{
    LevelTable table = testsupport::levelTable(1000);
    FacingBins facing = facingBinsOf(testsupport::ball(8, 16));
    SelectionSettings settings;
    SelectableObject object;

    explicit ParallelFixture(SelectionMethod method)
    {
        settings.method = method;
        settings.ranges = {{10.0, 20.0, 40.0, 90.0}, {0, 100, 200, 400, 700}};
        settings.overlappingRanges = OverlappingRanges::around(settings.ranges);
        settings.areaRows = AreaRows::halving(table);
        object.sphere = {{0, 0, 0}, 1.0};
        object.box = {{0, 0, 0}, glm::dmat3(1), glm::dvec3(1.0 / std::sqrt(3.0))};
        object.table = &table;
        object.settings = &settings;
        object.facing = &facing;
    }
    ParallelFixture(const ParallelFixture&) = delete;
    ParallelFixture& operator=(const ParallelFixture&) = delete;

    Selection in(const viewlod::ViewState& view, double reference = 0.0, double magnification = 1.0) const
    {
        HeldLevel none;
        return LevelSelector(SelectionView::from(view, magnification, reference)).select(object, none);
    }
};

TEST(ParallelView, AreasAreThoseOfTheShapesOverThePixels)
{
    const double pixel = 0.04; // metres
    const auto view = SelectionView::from(parallel(pixel));
    const double circle = std::numbers::pi * 1.5 * 1.5 / (pixel * pixel);
    for (const double deeper : {-300.0, 0.0, 20000.0})
    {
        const glm::dvec3 at = -glm::normalize(kEye) * deeper + glm::dvec3(1.0, 2.0, 3.0);
        EXPECT_NEAR(sphereAreaPx(view, {at, 1.5}), circle, 1e-4 * circle) << deeper;
        const OrientedBox cube{at, glm::dmat3(1.0), glm::dvec3(1.5)};
        EXPECT_NEAR(ellipsoidAreaPx(view, {at, glm::dmat3(1.5)}), circle, 1e-4 * circle);
        // Each face by how much it is turned to the eye.
        const glm::dvec3 towards = glm::abs(glm::normalize(kEye));
        const double box = 9.0 * (towards.x + towards.y + towards.z) / (pixel * pixel);
        EXPECT_NEAR(boxAreaPx(view, cube), box, 1e-4 * box);
    }
}

TEST(ParallelView, IsOneFromFarAwayToEveryRule)
{
    for (const SelectionMethod method :
         {SelectionMethod::ranges, SelectionMethod::overlappingRanges, SelectionMethod::boxArea,
          SelectionMethod::sphereArea, SelectionMethod::ellipsoidArea, SelectionMethod::facingArea,
          SelectionMethod::continuous, SelectionMethod::screenError})
    {
        SCOPED_TRACE(nameOf(method));
        const ParallelFixture fixture(method);
        std::uint32_t coarsest = 0, differ = 0, count = 0;
        for (double pixel = 0.01; pixel < 2.0; pixel *= 1.07, ++count)
        {
            // Distances of a camera whose tangent has 700 pixels.
            const Selection here = fixture.in(parallel(pixel), 700.0),
                            there = fixture.in(farAway(pixel), 700.0);
            EXPECT_NEAR(here.steps, there.steps, method == SelectionMethod::continuous ? 1.0 : 300.0)
                << pixel;
            differ += here.steps != there.steps;
            EXPECT_GE(here.steps, coarsest) << "coarser with larger pixels";
            coarsest = std::max(coarsest, here.steps);
        }
        EXPECT_LE(differ, count / 20) << "boundaries of rows";
        EXPECT_GE(coarsest, 400u);
        EXPECT_NE(fixture.in(parallel(0.02), 700.0).steps, fixture.in(farAway(1.5), 700.0).steps)
            << "would be noticed";
    }
}

TEST(ParallelView, TheScreenErrorIsThatInItsPixels)
{
    const ParallelFixture fixture(SelectionMethod::screenError);
    for (const double pixel : {0.00011, 0.0011, 0.011}) // between the errors of two levels
    {
        const std::uint32_t steps = fixture.in(parallel(pixel)).steps;
        EXPECT_EQ(steps, coarsestWithin(fixture.table, pixel));
        EXPECT_EQ(fixture.in(parallel(pixel), 0.0, 4.0).steps, fixture.in(parallel(pixel / 4.0)).steps)
            << "a device that magnifies";
    }
}

TEST(ParallelView, DistancesAreThoseOfTheReferenceOrElseFromItsPlace)
{
    const ParallelFixture fixture(SelectionMethod::ranges);
    // 30 m away a pixel of the reference is 3 / 70 m.
    EXPECT_EQ(fixture.in(parallel(3.0 / 70.0), 700.0).steps, 200u);
    EXPECT_EQ(fixture.in(parallel(3.0 / 70.0, 7.0 * kEye), 700.0).steps, 200u) << "wherever it stands";
    EXPECT_EQ(fixture.in(parallel(0.5, glm::normalize(kEye) * 30.0)).steps, 200u);
    EXPECT_EQ(fixture.in(parallel(0.01, glm::normalize(kEye) * 95.0)).steps, 700u);
    ParallelFixture fading(SelectionMethod::screenError);
    fading.settings.alpha = {20.0, 60.0};
    EXPECT_FLOAT_EQ(fading.in(parallel(0.5, glm::normalize(kEye) * 50.0)).alpha, 0.25F);
}

} // namespace
