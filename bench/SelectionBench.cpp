// SPDX-License-Identifier: Apache-2.0
// Measures how levels are chosen for a field of 10 000 objects: by each rule, by one budget for the scene
// along a flight; and switching.
#include <memory>

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>

#include <osgPMObjects/core/selection/SceneSelector.h>
#include <osgPMObjects/core/selection/Switch.h>

#include "Random.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::Random;

constexpr std::size_t kObjects = 10'000;

/// A field of 1.5 km by 1.5 km with objects of ten models, of 1000 to 10 000 positions each.
struct Field
{
    std::vector<LevelTable> tables;
    std::vector<BenefitCurve> curves;
    std::vector<FacingBins> facings;
    std::vector<SelectionSettings> settings;
    std::vector<SelectableObject> objects;
    std::vector<HeldLevel> held;
    std::vector<Selection> selections;

    explicit Field(SelectionMethod method)
    {
        constexpr std::uint32_t kModels = 10;
        Random random(1);
        tables.resize(kModels);
        facings.resize(kModels);
        settings.resize(kModels);
        for (std::uint32_t model = 0; model < kModels; ++model)
        {
            LevelTable& table = tables[model];
            table.positions = 1000 * (model + 1);
            table.area = 50.0;
            for (std::uint32_t steps = 0; steps + 4 <= table.positions; ++steps)
            {
                table.faces.push_back(2 * (table.positions - steps) - 4);
                table.errors.push_back(
                    {static_cast<float>(5.0 / (table.positions - steps) - 5.0 / table.positions)});
            }
            curves.push_back(BenefitCurve::of(table, 3.0, {}));
            for (glm::vec3& area : facings[model].areas)
                area = glm::vec3(random.unit(), random.unit(), random.unit()) - 0.5f;
            settings[model].method = method;
            settings[model].ranges = {{50.0, 100.0, 200.0, 400.0}, {0, 100, 200, 400, 700}};
            settings[model].overlappingRanges = OverlappingRanges::around(settings[model].ranges);
            settings[model].areaRows = AreaRows::halving(table);
        }
        for (std::size_t i = 0; i < kObjects; ++i)
            addObject(random);
        held.resize(kObjects);
        selections.resize(kObjects);
    }

    void addObject(Random& random)
    {
        SelectableObject object;
        const std::size_t model = random.below(10);
        object.sphere = {{1500.0 * random.unit() - 750.0, 1500.0 * random.unit(), 0.0}, 3.0};
        object.box.centre = object.sphere.centre;
        object.box.halfSizes = glm::dvec3(1.7);
        object.table = &tables[model];
        object.curve = &curves[model];
        object.facing = &facings[model];
        object.settings = &settings[model];
        objects.push_back(object);
    }
};

/// Returns the selector of a frame. The eye moves 1 m a frame, 20 m above the field, and starts again after
/// 1000 frames.
LevelSelector selectorOf(int frame)
{
    const glm::dvec3 eye{0.0, -200.0 + frame % 1000, 20.0};
    return LevelSelector(SelectionView::from(viewlod::ViewState::fromMatrices(
        glm::lookAt(eye, eye + glm::dvec3(0, 1, -0.02), {0, 0, 1}),
        glm::perspective(glm::radians(40.0), 1280.0 / 720.0, 0.1, 1e5), 1280, 720)));
}

void rule(benchmark::State& state, SelectionMethod method)
{
    Field field(method);
    int frame = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        const LevelSelector selector = selectorOf(frame++);
        for (std::size_t i = 0; i < kObjects; ++i)
            field.selections[i] = selector.select(field.objects[i], field.held[i]);
        benchmark::ClobberMemory();
    }
    state.counters["ns_an_object"] = benchmark::Counter(
        1e-9 * kObjects, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK_CAPTURE(rule, ranges, SelectionMethod::ranges)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, overlapping, SelectionMethod::overlappingRanges)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, boxArea, SelectionMethod::boxArea)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, sphereArea, SelectionMethod::sphereArea)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, ellipsoidArea, SelectionMethod::ellipsoidArea)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, facingArea, SelectionMethod::facingArea)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, continuous, SelectionMethod::continuous)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(rule, screenError, SelectionMethod::screenError)->Unit(benchmark::kMicrosecond);

/// Measures selection under a budget. Arguments: the budget, in per cent of the triangles without one, and
/// the metres that the eye moves in a frame.
void budget(benchmark::State& state)
{
    Field field(SelectionMethod::budget);
    SceneSelector selector;
    const auto select = [&](int frame, const SceneBudgetSettings& settings)
    { return selector.select(selectorOf(frame), field.objects, field.held, field.selections, settings); };
    const std::uint64_t wanted = select(0, {}).budget.cost;
    const auto jump = static_cast<int>(state.range(1));
    SceneBudgetSettings settings;
    settings.budget = wanted * static_cast<std::uint64_t>(state.range(0)) / 100;
    int frame = 0;
    double changes = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        const BudgetResult result = select(frame += jump, settings).budget;
        changes += result.refined + result.coarsened;
    }
    state.counters["changes_a_frame"] = changes / static_cast<double>(state.iterations());
    state.counters["triangles"] = static_cast<double>(settings.budget);
}
BENCHMARK(budget)
    ->ArgNames({"share", "jump"})
    ->ArgsProduct({{100, 50, 20}, {0, 1, 300}})
    ->Unit(benchmark::kMicrosecond);

void switching(benchmark::State& state)
{
    std::vector<SwitchState> states(kObjects, SwitchState::at(0));
    std::uint32_t frame = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        const std::uint32_t target = frame++ / 64; // a new level about every 2 s
        for (std::uint32_t i = 0; i < kObjects; ++i)
            benchmark::DoNotOptimize(advanceSwitch(states[i], target + i % 3, 1.0f / 30.0f, 1.0f, i, {}));
    }
    state.counters["ns_an_object"] = benchmark::Counter(
        1e-9 * kObjects, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(switching)->Unit(benchmark::kMicrosecond);

} // namespace

BENCHMARK_MAIN();
