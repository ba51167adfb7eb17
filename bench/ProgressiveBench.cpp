// SPDX-License-Identifier: Apache-2.0
// Measures progressive meshes: single steps between levels, jumps to a level, and building. The argument
// `mesh` is a Subject, `arrangement` an Arrangement.
#include <map>
#include <utility>

#include <benchmark/benchmark.h>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "ScannedMeshes.h"
#include "SimplifyMeshes.h"
#include "TableForm.h"

namespace
{

using namespace osgPMObjects::core;

enum class Subject
{
    waves,   ///< a grid in waves, 69 938 faces
    scanned, ///< a closed blob of irregular edges, 70 688 faces
};

const Mesh& meshOf(Subject subject)
{
    static const Mesh waves = testsupport::waves(187, 187);
    static const Mesh scanned = testsupport::scannedBlob(94);
    return subject == Subject::waves ? waves : scanned;
}

const CollapseSequence& sequenceOf(Subject subject)
{
    static std::map<Subject, CollapseSequence> made;
    const auto [at, isNew] = made.try_emplace(subject);
    if (isNew) at->second = simplify(meshOf(subject));
    return at->second;
}

const ProgressiveMesh& progressive(Subject subject, Arrangement arrangement)
{
    static std::map<std::pair<Subject, Arrangement>, ProgressiveMesh> made;
    const auto [at, isNew] = made.try_emplace({subject, arrangement});
    if (isNew)
        at->second = buildProgressiveMesh(meshOf(subject), sequenceOf(subject), {.arrangement = arrangement});
    return at->second;
}

/// Measures steps to the coarsest level and back. Items: steps.
void stepDownAndUp(benchmark::State& state)
{
    const ProgressiveMesh& mesh =
        progressive(static_cast<Subject>(state.range(0)), static_cast<Arrangement>(state.range(1)));
    ProgressiveLevel level(mesh);
    for ([[maybe_unused]] auto _ : state)
    {
        level.moveTo(mesh.stepCount);
        level.moveTo(0);
    }
    state.SetItemsProcessed(state.iterations() * 2 * mesh.stepCount);
    state.counters["bytesPerVertex"] =
        static_cast<double>(mesh.overheadBytes()) / static_cast<double>(mesh.mesh.wedgeCount());
}
BENCHMARK(stepDownAndUp)
    ->ArgsProduct({{0, 1}, {0, 1, 2, 3}})
    ->ArgNames({"mesh", "arrangement"})
    ->Unit(benchmark::kMillisecond);

/// Measures the same for tswap at a share in per cent, by cycles or by tables of all faces.
void stepByForm(benchmark::State& state)
{
    const auto subject = static_cast<Subject>(state.range(0));
    const ProgressiveMesh cycles = buildProgressiveMesh(
        meshOf(subject), sequenceOf(subject),
        {.arrangement = Arrangement::tswap, .tswapStep = 0.01f * static_cast<float>(state.range(1))});
    const ProgressiveMesh mesh = state.range(2) == 0 ? cycles : testsupport::TableForm(cycles).tables();
    ProgressiveLevel level(mesh);
    for ([[maybe_unused]] auto _ : state)
    {
        level.moveTo(mesh.stepCount);
        level.moveTo(0);
    }
    state.SetItemsProcessed(state.iterations() * 2 * mesh.stepCount);
    state.counters["bytesPerVertex"] =
        static_cast<double>(mesh.overheadBytes()) / static_cast<double>(mesh.mesh.wedgeCount());
}
BENCHMARK(stepByForm)
    ->ArgsProduct({{0, 1}, {5, 10, 20, 30}, {0, 1}})
    ->ArgNames({"mesh", "percent", "tables"})
    ->Unit(benchmark::kMillisecond);

/// Measures one pass over all faces that makes the level of a percentage of the positions.
void jump(benchmark::State& state)
{
    const ProgressiveMesh& mesh = progressive(static_cast<Subject>(state.range(0)), Arrangement::windows);
    CompactedLevel level(mesh);
    for ([[maybe_unused]] auto _ : state)
        level.moveTo(
            static_cast<std::uint32_t>(std::uint64_t{mesh.stepCount} * (100 - state.range(1)) / 100));
}
BENCHMARK(jump)
    ->ArgsProduct({{0, 1}, {100, 75, 50, 10}})
    ->ArgNames({"mesh", "percent"})
    ->Unit(benchmark::kMicrosecond);

void build(benchmark::State& state)
{
    const auto subject = static_cast<Subject>(state.range(0));
    sequenceOf(subject);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(buildProgressiveMesh(
            meshOf(subject), sequenceOf(subject), {.arrangement = static_cast<Arrangement>(state.range(1))}));
}
BENCHMARK(build)
    ->ArgsProduct({{0, 1}, {0, 1, 2, 3}})
    ->ArgNames({"mesh", "arrangement"})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1);

} // namespace

BENCHMARK_MAIN();
