// SPDX-License-Identifier: Apache-2.0
// Measures progressive meshes: single steps between levels, jumps to a level, and building.
#include <map>

#include <benchmark/benchmark.h>

#include <osgPMObjects/core/progressive/CompactedLevel.h>
#include <osgPMObjects/core/progressive/ProgressiveLevel.h>
#include <osgPMObjects/core/simplify/Simplify.h>

#include "SimplifyMeshes.h"

namespace
{

using namespace osgPMObjects::core;

constexpr std::uint32_t kSide = 187; // 69 938 faces

const Mesh& subject()
{
    static const Mesh mesh = testsupport::waves(kSide, kSide);
    return mesh;
}

const CollapseSequence& sequence()
{
    static const CollapseSequence made = simplify(subject());
    return made;
}

const ProgressiveMesh& progressive(Arrangement arrangement)
{
    static std::map<Arrangement, ProgressiveMesh> made;
    const auto [at, isNew] = made.try_emplace(arrangement);
    if (isNew) at->second = buildProgressiveMesh(subject(), sequence(), {.arrangement = arrangement});
    return at->second;
}

/// Measures steps to the coarsest level and back. Argument: an Arrangement. Items: steps.
void stepDownAndUp(benchmark::State& state)
{
    const ProgressiveMesh& mesh = progressive(static_cast<Arrangement>(state.range(0)));
    ProgressiveLevel level(mesh);
    for (auto _ : state)
    {
        level.moveTo(mesh.stepCount);
        level.moveTo(0);
    }
    state.SetItemsProcessed(state.iterations() * 2 * mesh.stepCount);
    state.counters["bytesPerVertex"] =
        static_cast<double>(mesh.overheadBytes()) / static_cast<double>(mesh.mesh.wedgeCount());
}
BENCHMARK(stepDownAndUp)->DenseRange(0, 3)->ArgName("arrangement")->Unit(benchmark::kMillisecond);

/// Measures making a level in one pass. Argument: the positions that it keeps, in per cent.
void jump(benchmark::State& state)
{
    const ProgressiveMesh& mesh = progressive(Arrangement::windows);
    CompactedLevel level(mesh);
    for (auto _ : state)
        level.moveTo(
            static_cast<std::uint32_t>(std::uint64_t{mesh.stepCount} * (100 - state.range(0)) / 100));
}
BENCHMARK(jump)->Arg(100)->Arg(50)->Arg(10)->ArgName("percent")->Unit(benchmark::kMicrosecond);

void build(benchmark::State& state)
{
    sequence();
    for (auto _ : state)
        benchmark::DoNotOptimize(buildProgressiveMesh(
            subject(), sequence(), {.arrangement = static_cast<Arrangement>(state.range(0))}));
}
BENCHMARK(build)->DenseRange(0, 3)->ArgName("arrangement")->Unit(benchmark::kMillisecond)->Iterations(1);

} // namespace

BENCHMARK_MAIN();
