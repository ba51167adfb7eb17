// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/ContinuousRule.h>
#include <osgPMObjects/core/selection/LevelSelector.h>

#include "ClosedMeshes.h"
#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

/// An object of every method, with what each needs.
struct SelectorFixture
{
    LevelTable table = testsupport::levelTable(1000);
    BenefitCurve curve = BenefitCurve::of(table, 1.0, {});
    FacingBins facing = facingBinsOf(testsupport::ball(8, 16));
    SelectionSettings settings;
    SelectableObject object;

    explicit SelectorFixture(SelectionMethod method)
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
        object.curve = &curve;
    }
    SelectorFixture(const SelectorFixture&) = delete;
    SelectorFixture& operator=(const SelectorFixture&) = delete;

    Selection at(double distance, HeldLevel& held, double magnification = 1.0, double reference = 0.0,
                 double highDeg = 40.0) const
    {
        const auto view = testsupport::viewTo({0, -distance, 0}, {0, 0, 0}, highDeg);
        return LevelSelector(SelectionView::from(view, magnification, reference)).select(object, held);
    }
    Selection at(double distance, double magnification = 1.0, double reference = 0.0,
                 double highDeg = 40.0) const
    {
        HeldLevel none;
        return at(distance, none, magnification, reference, highDeg);
    }
};

const std::vector<SelectionMethod> kOwnRules = {
    SelectionMethod::ranges,     SelectionMethod::overlappingRanges, SelectionMethod::boxArea,
    SelectionMethod::sphereArea, SelectionMethod::ellipsoidArea,     SelectionMethod::facingArea,
    SelectionMethod::continuous, SelectionMethod::screenError};

TEST(LevelSelector, EveryRuleGoesFromFineToCoarseWithDistance)
{
    for (const SelectionMethod method : kOwnRules)
    {
        SCOPED_TRACE(nameOf(method));
        const SelectorFixture fixture(method);
        ASSERT_TRUE(checkSettings(fixture.settings, fixture.table.mostSteps() + 1));
        HeldLevel held;
        const std::uint32_t first = fixture.at(3.0, held).steps;
        std::uint32_t last = first;
        int switches = 0;
        for (double distance = 3.0; distance < 40'000.0; distance *= 1.01)
        {
            const Selection selection = fixture.at(distance, held);
            EXPECT_GE(selection.steps, last);
            EXPECT_EQ(selection.hasSwitched, selection.steps != last);
            switches += selection.hasSwitched;
            last = selection.steps;
        }
        EXPECT_GE(switches, 4);
        EXPECT_GE(last, 700u);
        const std::uint32_t back = fixture.at(3.0, held).steps;
        if (method != SelectionMethod::screenError)
        {
            EXPECT_EQ(back, first);
            continue;
        }
        const auto view = SelectionView::from(testsupport::viewTo({0, -3.0, 0}, {0, 0, 0}));
        const double tolerance = LevelSelector(view).toleranceOf(fixture.object, 1.0);
        EXPECT_EQ(first, coarsestWithin(fixture.table, tolerance)) << "the first choice needs no band";
        EXPECT_EQ(back, coarsestWithin(fixture.table, tolerance / kDefaultBand));
    }
}

TEST(LevelSelector, EveryRuleWithABandIsCalmWhereThePlainOnesAreNot)
{
    Random random(20);
    for (const SelectionMethod method : kOwnRules)
    {
        SCOPED_TRACE(nameOf(method));
        SelectorFixture fixture(method);
        fixture.settings.continuousBand = kDefaultBand;
        int most = 0;
        for (double middle = 8.0; middle < 3000.0; middle *= 1.03)
        {
            HeldLevel held;
            const auto level = [&](double d) { return fixture.at(d, held).steps; };
            most = std::max(most, testsupport::switchesWhileTrembling(middle, 0.05, 3, level));
            most = std::max(most, testsupport::switchesWhileWalking(random, middle, 0.05, 60, level));
        }
        if (method == SelectionMethod::ranges)
            EXPECT_GT(most, 1);
        else
            EXPECT_LE(most, 1);
    }
}

TEST(LevelSelector, NoRuleChoosesFewerThanTheLeastFaces)
{
    constexpr double kFarAway = 40'000.0;
    for (const SelectionMethod method : kOwnRules)
    {
        SelectorFixture fixture(method);
        const std::uint32_t least = fixture.table.faces[500];
        EXPECT_LT(fixture.table.faces[fixture.at(kFarAway).steps], least) << nameOf(method);
        fixture.settings.leastFaces = least;
        EXPECT_EQ(fixture.at(kFarAway).steps, fixture.table.coarsestWith(least)) << nameOf(method);
        EXPECT_LE(fixture.at(3.0).steps, fixture.at(kFarAway).steps);
    }
}

TEST(LevelSelector, AMagnificationBringsObjectsNearAsManyTimes)
{
    for (const SelectionMethod method : {SelectionMethod::ranges, SelectionMethod::overlappingRanges,
                                         SelectionMethod::continuous, SelectionMethod::facingArea})
        for (const double distance : {15.0, 50.0, 300.0, 2000.0})
        {
            const SelectorFixture fixture(method);
            EXPECT_EQ(fixture.at(4.0 * distance, 4.0).steps, fixture.at(distance).steps)
                << nameOf(method) << ' ' << distance;
        }
}

TEST(LevelSelector, ImportanceMagnifiesLikeADevice)
{
    for (const SelectionMethod method : kOwnRules)
        for (const double distance : {15.0, 50.0, 300.0, 2000.0})
        {
            SelectorFixture fixture(method);
            const std::uint32_t plain = fixture.at(distance).steps;
            const std::uint32_t magnified = fixture.at(distance, 3.0).steps;
            fixture.object.priority.importance = 3.0;
            const std::uint32_t important = fixture.at(distance).steps;
            EXPECT_EQ(important, magnified) << nameOf(method) << ' ' << distance;
            EXPECT_LE(important, plain);
            fixture.object.priority = {.importance = 1.5, .isAttended = true};
            EXPECT_EQ(fixture.at(distance).steps, magnified) << nameOf(method) << ' ' << distance;
        }
}

TEST(LevelSelector, ACameraThatZoomsIsADeviceThatMagnifies)
{
    // A quarter of the tangent, with distances meant for the wide camera.
    const double narrow = glm::degrees(2.0 * std::atan(std::tan(glm::radians(20.0)) / 4.0));
    const double reference = testsupport::viewTo({0, -1, 0}, {0, 0, 0}).pixelsPerTangent;
    for (const SelectionMethod method :
         {SelectionMethod::ranges, SelectionMethod::overlappingRanges, SelectionMethod::continuous,
          SelectionMethod::sphereArea, SelectionMethod::boxArea, SelectionMethod::ellipsoidArea})
        for (const double distance : {15.0, 50.0, 300.0, 2000.0})
        {
            const SelectorFixture fixture(method);
            EXPECT_EQ(fixture.at(distance, 1.0, reference, narrow).steps, fixture.at(distance, 4.0).steps)
                << nameOf(method) << ' ' << distance;
        }
}

TEST(LevelSelector, TheContinuousRuleIsTheFormulaWithTheDefaultReference)
{
    SelectorFixture fixture(SelectionMethod::continuous);
    const double k = testsupport::viewTo({0, -1, 0}, {0, 0, 0}).pixelsPerTangent;
    const double z1 = referenceDistanceM(k, fixture.table.area, fixture.table.faces[0]);
    for (double z = 0.5 * z1; z < 30.0 * z1; z *= 1.003)
    {
        const Selection selection = fixture.at(z);
        const Removal expected = removalAt(z1, z, 1000, fixture.table.mostSteps());
        EXPECT_EQ(selection.steps, expected.steps);
        EXPECT_EQ(selection.reason == SelectionReason::clamped, expected.isClamped);
    }
    fixture.settings.referenceM = 10.0;
    EXPECT_EQ(fixture.at(20.0).steps, 749u); // 998 · 3/4, rounded
    EXPECT_EQ(fixture.at(40.0, 2.0).steps, 749u);
    fixture.settings.referenceM = 0.0;
    fixture.object.metresPerUnit = 2.0; // twice as large, the same at twice the distance
    EXPECT_EQ(fixture.at(6.0 * z1).steps, removalAt(z1, 3.0 * z1, 1000, 996).steps);
}

TEST(LevelSelector, FadesAndIsGone)
{
    SelectorFixture fixture(SelectionMethod::overlappingRanges);
    fixture.settings.alpha = {100.0, 200.0};
    HeldLevel held;
    EXPECT_EQ(fixture.at(100.0, held).alpha, 1.0f);
    EXPECT_FLOAT_EQ(fixture.at(150.0, held).alpha, 0.5f);
    EXPECT_TRUE(held.isHeld());
    const Selection gone = fixture.at(200.0, held);
    EXPECT_EQ(gone.alpha, 0.0f);
    EXPECT_EQ(gone.reason, SelectionReason::gone);
    EXPECT_FALSE(held.isHeld());
    EXPECT_FALSE(fixture.at(50.0, held).hasSwitched); // nobody saw it before
}

TEST(LevelSelector, IsFinestAndSaysSoWhereTheNearPlaneCuts)
{
    for (const SelectionMethod method : {SelectionMethod::boxArea, SelectionMethod::sphereArea,
                                         SelectionMethod::ellipsoidArea, SelectionMethod::facingArea})
    {
        const Selection selection = SelectorFixture(method).at(0.5);
        EXPECT_EQ(selection.steps, 0u) << nameOf(method);
        EXPECT_EQ(selection.reason, SelectionReason::fullArea) << nameOf(method);
    }
}

TEST(LevelSelector, TurningTheCameraChangesNoLevelByDistanceOrError)
{
    for (const SelectionMethod method :
         {SelectionMethod::ranges, SelectionMethod::continuous, SelectionMethod::screenError})
    {
        const SelectorFixture fixture(method);
        const auto looking = [&](const glm::dvec3& at)
        {
            HeldLevel held;
            const auto view = SelectionView::from(testsupport::viewTo({0, -60, 0}, at));
            return LevelSelector(view).select(fixture.object, held).steps;
        };
        EXPECT_EQ(looking({0, 0, 0}), looking({20, 0, 5})) << nameOf(method);
    }
}

TEST(SelectionSettings, ThatCannotChooseAreToldWithWhatIsWrong)
{
    const auto isRefused = [](auto change)
    {
        SelectorFixture fixture(SelectionMethod::ranges);
        change(fixture.settings);
        const auto outcome = checkSettings(fixture.settings, 900);
        return !outcome && !outcome.error().what.empty() && !outcome.error().remedy.empty();
    };
    EXPECT_FALSE(isRefused([](SelectionSettings&) {}));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.ranges.boundariesM[1] = 5.0; }));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.ranges.steps.back() = 900; }));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.ranges = {}; }));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.band = 0.9; }));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.tolerancePx = std::nan(""); }));
    EXPECT_TRUE(isRefused([](SelectionSettings& s) { s.alpha = {200.0, 100.0}; }));
    EXPECT_TRUE(isRefused(
        [](SelectionSettings& s)
        { s.method = SelectionMethod::overlappingRanges, s.overlappingRanges.boundaries[0].farM = 1.0; }));
    EXPECT_TRUE(
        isRefused([](SelectionSettings& s) { s.method = SelectionMethod::boxArea, s.areaRows = {}; }));
    // What the method does not look at does not matter.
    EXPECT_FALSE(
        isRefused([](SelectionSettings& s) { s.method = SelectionMethod::screenError, s.ranges = {}; }));
}

} // namespace
