// SPDX-License-Identifier: Apache-2.0
#include <array>

#include <gtest/gtest.h>

#include <osgPMObjects/core/selection/SceneSelector.h>

#include "ClosedMeshes.h"
#include "SelectionScenes.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

/// Objects around the origin, with all methods in turn or with one.
struct Field
{
    LevelTable table = testsupport::levelTable(1000);
    BenefitCurve curve = BenefitCurve::of(table, 1.0, {});
    FacingBins facing = facingBinsOf(testsupport::ball(8, 16));
    std::array<SelectionSettings, kSelectionMethods> settings;
    std::vector<SelectableObject> objects;
    std::vector<HeldLevel> held;
    std::vector<Selection> selections;
    SceneSelector selector;

    explicit Field(std::size_t count, std::optional<SelectionMethod> only = {})
    {
        Random random(21);
        for (std::size_t method = 0; method < kSelectionMethods; ++method)
        {
            settings[method].method = static_cast<SelectionMethod>(method);
            settings[method].ranges = {{50.0, 100.0, 200.0}, {0, 100, 200, 400}};
            settings[method].overlappingRanges = OverlappingRanges::around(settings[method].ranges);
            settings[method].areaRows = AreaRows::halving(table);
            settings[method].alpha = {600.0, 700.0};
            settings[method].tolerancePx = 0.01; // the table's errors are small
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            SelectableObject object;
            object.sphere = {
                {testsupport::between(random, -500, 500), testsupport::between(random, 20, 900), 0.0}, 1.0};
            object.box = {object.sphere.centre, testsupport::rotation(random), glm::dvec3(0.577)};
            object.table = &table;
            object.curve = &curve;
            object.facing = &facing;
            object.settings = &settings[only ? static_cast<std::size_t>(*only) : i % kSelectionMethods];
            objects.push_back(object);
        }
        held.resize(count);
        selections.resize(count);
    }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;

    SelectionStatistics select(const glm::dvec3& eye, const SceneBudgetSettings& budget = {})
    {
        const LevelSelector level(SelectionView::from(testsupport::viewTo(eye, eye + glm::dvec3(0, 1, 0))));
        return selector.select(level, objects, held, selections, budget);
    }
    std::uint64_t drawn() const
    {
        std::uint64_t triangles = 0;
        for (const Selection& selection : selections)
            triangles += selection.reason == SelectionReason::gone ? 0 : table.faces[selection.steps];
        return triangles;
    }
};

TEST(SceneSelector, CountsEveryObjectUnderItsMethod)
{
    Field field(900);
    field.select({0, 0, 0});
    const SelectionStatistics statistics = field.select({0, 60, 0});
    for (const MethodStatistics& method : statistics.byMethod)
    {
        EXPECT_EQ(method.objects, 100u);
        EXPECT_GT(method.gone, 0u);
        EXPECT_GT(method.faded, 0u);
        EXPECT_GT(method.switched, 0u);
    }
    const MethodStatistics all = statistics.all();
    EXPECT_EQ(all.objects, 900u);
    EXPECT_EQ(all.triangles, field.drawn());
    std::uint32_t switched = 0, gone = 0, clamped = 0;
    for (const Selection& selection : field.selections)
    {
        switched += selection.hasSwitched;
        gone += selection.reason == SelectionReason::gone;
        clamped += selection.reason == SelectionReason::clamped;
    }
    EXPECT_EQ(all.switched, switched);
    EXPECT_EQ(all.gone, gone);
    EXPECT_EQ(all.clamped, clamped);
    EXPECT_EQ(field.select({0, 60, 0}).all().switched, 0u); // nothing has moved
}

TEST(SceneSelector, SharesTheBudgetThatOthersLeave)
{
    Field field(900);
    const std::uint64_t needed = field.select({0, 0, 0}).all().triangles;
    const std::uint64_t shared = field.select({0, 0, 0}).budget.cost;
    ASSERT_GT(shared, 2000u);
    const SelectionStatistics tight = field.select({0, 0, 0}, {.budget = needed - shared / 2});
    EXPECT_TRUE(tight.budget.fits);
    EXPECT_LE(field.drawn(), needed - shared / 2);
    EXPECT_GT(tight.budget.refused, 0u);
    EXPECT_GT(tight.of(SelectionMethod::budget).switched, 0u);
    // The objects with their own rules exceed the budget: the others are coarsest, and `fits` is false.
    const SelectionStatistics none = field.select({0, 0, 0}, {.budget = 10});
    EXPECT_FALSE(none.budget.fits);
    for (std::size_t i = 0; i < field.objects.size(); ++i)
        if (field.objects[i].settings->method == SelectionMethod::budget && field.held[i].isHeld())
        {
            EXPECT_EQ(field.held[i].level, 0u);
        }
}

TEST(SceneSelector, WithoutABudgetChoosesByTolerance)
{
    Field byBudget(400, SelectionMethod::budget), byError(400, SelectionMethod::screenError);
    byBudget.select({0, 0, 0});
    byError.select({0, 0, 0});
    for (std::size_t i = 0; i < 400; ++i) // its points are some of the levels: as fine or finer
        EXPECT_LE(byBudget.selections[i].steps, byError.selections[i].steps);
}

TEST(SceneSelector, GivesImportantObjectsMoreOfABudget)
{
    Field field(600, SelectionMethod::budget);
    const std::uint64_t needed = field.select({0, 0, 0}).all().triangles;
    const SceneBudgetSettings half{.budget = needed / 2};
    field.select({0, 0, 0}, half);
    const auto before = field.selections;
    double finer = 0, coarser = 0;
    for (std::size_t i = 0; i < 600; i += 20)
        field.objects[i].priority.isAttended = true;
    field.select({0, 0, 0}, half);
    EXPECT_LE(field.drawn(), needed / 2);
    for (std::size_t i = 0; i < 600; ++i)
    {
        const bool isFiner = field.selections[i].steps < before[i].steps;
        const bool isCoarser = field.selections[i].steps > before[i].steps;
        finer += isFiner;
        coarser += isCoarser;
        EXPECT_FALSE(isCoarser && i % 20 == 0) << i;
    }
    EXPECT_GT(finer, 10);
    EXPECT_GT(coarser, 0);
}

TEST(SceneSelector, IsCalmWhileTheEyeTrembles)
{
    for (const double band : {SceneBudget::kDefaultBand, 1.0})
    {
        Field field(500, SelectionMethod::budget);
        for (SelectionSettings& settings : field.settings)
        {
            settings.band = band == 1.0 ? 1.0 : kDefaultBand;
            settings.alpha = {};
        }
        const std::uint64_t needed = field.select({0, -280.0, 0}).all().triangles;
        std::vector<int> changes(500, 0);
        int most = 0;
        for (int frame = 0; frame < 300; ++frame)
        {
            // 15 m to either side are 5 % of the 300 m that the nearest object is away.
            const glm::dvec3 eye{15.0 * std::sin(0.1 * frame), -280.0, 0.0};
            field.select(eye, {.budget = needed / 2, .band = band});
            for (std::size_t i = 0; i < 500 && frame > 0; ++i)
                most = std::max(most, changes[i] += field.selections[i].hasSwitched);
        }
        if (band == 1.0)
            EXPECT_GT(most, 3);
        else
            EXPECT_LE(most, 1);
    }
}

} // namespace
