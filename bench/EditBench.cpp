// SPDX-License-Identifier: Apache-2.0
// Measures the time of an edit for each sample that it changes, over tiles of growing size: it must not
// depend on the size.
//   build/bin/edit_bench
#include <algorithm>
#include <chrono>
#include <vector>

#include <benchmark/benchmark.h>

#include <osgTerrainROAM/core/edit/GroundEditor.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>

#include "SyntheticField.h"
#include "measurement/Percentile.h"

namespace
{

using namespace osgTerrainROAM::core;
using Clock = std::chrono::steady_clock;

double microsecondsSince(Clock::time_point start)
{
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

std::shared_ptr<RoamTile> tileOf(int side, int gridExponent)
{
    return std::make_shared<RoamTile>(PlacedTile(
        testsupport::hills(side, side), {.placement = Placement::planar, .gridExponent = gridExponent}));
}

/// Returns changes that raise the samples of a random square by up to a metre each. `across`: samples a side.
std::vector<HeightChange> square(const PlacedTile& tile, int across, testsupport::Random& random)
{
    const auto room = static_cast<std::uint32_t>(tile.grid().dataColumns() - across);
    const int west = static_cast<int>(random.below(room)), south = static_cast<int>(random.below(room));
    std::vector<HeightChange> changes;
    for (int row = south; row < south + across; ++row)
        for (int column = west; column < west + across; ++column)
            changes.push_back(
                {{column, row}, tile.samples().heightM(column, row) + static_cast<float>(random.unit())});
    return changes;
}

void report(benchmark::State& state, std::vector<double>& usPerSample)
{
    state.counters["p50_us_per_sample"] = measurement::percentile(usPerSample, 0.5);
    state.counters["p99_us_per_sample"] = measurement::percentile(usPerSample, 0.99);
}

/// Measures edits. Arguments: samples along a side of the tile, and of the edited square.
void editSamples(benchmark::State& state)
{
    const auto tile = tileOf(static_cast<int>(state.range(0)), 0);
    TileEditor editor(tile);
    testsupport::Random random(1);
    std::vector<double> usPerSample;
    for ([[maybe_unused]] auto _ : state)
    {
        const auto changes = square(tile->tile, static_cast<int>(state.range(1)), random);
        const auto start = Clock::now();
        if (!editor.apply(changes, TileEditor::Between::follows)) state.SkipWithError("refused");
        usPerSample.push_back(microsecondsSince(start) / static_cast<double>(changes.size()));
        editor.forgetUndo();
    }
    report(state, usPerSample);
}
BENCHMARK(editSamples)
    ->ArgsProduct({{257, 513, 1025, 2049}, {1, 4, 32}})
    ->Iterations(400)
    ->Unit(benchmark::kMicrosecond);

/// Measures how long a mesh takes to follow such edits while the eye stands still. Arguments: as
/// editSamples().
void followSamples(benchmark::State& state)
{
    const auto tile = tileOf(static_cast<int>(state.range(0)), 0);
    TileEditor editor(tile);
    RoamMesh mesh{SplitBounds(tile)};
    viewlod::ViewState view;
    const double middle = 15.0 * (static_cast<double>(state.range(0)) - 1.0);
    view.eyeWorld = {middle, middle, 900.0};
    view.pixelsPerTangent = 1000.0;
    mesh.refine(view, {.errorTolerancePx = 2.0});
    testsupport::Random random(1);
    std::vector<double> usPerSample;
    for ([[maybe_unused]] auto _ : state)
    {
        const auto changes = square(tile->tile, static_cast<int>(state.range(1)), random);
        if (!editor.apply(changes, TileEditor::Between::follows)) state.SkipWithError("refused");
        editor.forgetUndo();
        const auto start = Clock::now();
        mesh.refine(view, {.errorTolerancePx = 2.0});
        usPerSample.push_back(microsecondsSince(start) / static_cast<double>(changes.size()));
    }
    state.counters["triangles"] = mesh.tree().leafCount();
    report(state, usPerSample);
}
BENCHMARK(followSamples)
    ->ArgsProduct({{513, 1025, 2049}, {4, 32}})
    ->Iterations(200)
    ->Unit(benchmark::kMicrosecond);

/// Measures building a road 7 m wide and 300 m long between samples 30 m apart, on a grid of 0.47 m.
void buildRoad(benchmark::State& state)
{
    const auto tile = tileOf(static_cast<int>(state.range(0)), 6);
    GroundEditor editor(tile);
    std::vector<double> usPerSample;
    for ([[maybe_unused]] auto _ : state)
    {
        const auto start = Clock::now();
        const auto done = editor.conform(Ribbon{.points = {{1000, 1000}, {1180, 1240}}});
        if (!done) state.SkipWithError("refused");
        usPerSample.push_back(microsecondsSince(start) / static_cast<double>(done->samplesChanged));
        state.counters["samples"] = static_cast<double>(done->samplesChanged);
        editor.undo();
    }
    report(state, usPerSample);
}
BENCHMARK(buildRoad)->Arg(129)->Arg(513)->Arg(1025)->Iterations(5)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
