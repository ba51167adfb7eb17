// SPDX-License-Identifier: Apache-2.0
// Measures the tessellation of polygons, and orders of triangles.
#include <benchmark/benchmark.h>

#include <osgPMObjects/core/order/TriangleOrders.h>
#include <osgPMObjects/core/order/TriangleStrips.h>
#include <osgPMObjects/core/tessellate/ConvexDecomposition.h>
#include <osgPMObjects/core/tessellate/Tessellation.h>

#include "OrderMeshes.h"
#include "TestPolygons.h"

namespace
{

using namespace osgPMObjects::core;
using testsupport::IndexedMesh;
using testsupport::Polygon;
using testsupport::Random;

/// Returns a star with as many corners as the benchmark's first argument says.
Polygon starFor(const benchmark::State& state, std::uint64_t seed)
{
    Random random(seed);
    Polygon star;
    star.add(testsupport::star(random, {0, 0}, 1.0, static_cast<std::uint32_t>(state.range(0))));
    return star;
}

void tessellateStar(benchmark::State& state)
{
    const Polygon star = starFor(state, 1);
    const auto corners = star.inSpace();
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(tessellate(corners, star.contourSizes));
    state.SetItemsProcessed(state.iterations() * state.range(0));
}
BENCHMARK(tessellateStar)->RangeMultiplier(10)->Range(4, 40'000)->Unit(benchmark::kMicrosecond);

void tessellateHoles(benchmark::State& state)
{ // a square with a grid of small holes; argument: holes along a side
    Random random(2);
    Polygon sheet;
    const auto side = static_cast<std::uint32_t>(state.range(0));
    sheet.add({{0, 0}, {double(side), 0}, {double(side), double(side)}, {0, double(side)}});
    for (std::uint32_t i = 0; i < side * side; ++i)
        sheet.add(testsupport::star(random, {i % side + 0.5, i / side + 0.5}, 0.4, 8));
    const auto corners = sheet.inSpace();
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(tessellate(corners, sheet.contourSizes));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(corners.size()));
}
BENCHMARK(tessellateHoles)->Arg(2)->Arg(8)->Arg(32)->Unit(benchmark::kMicrosecond);

void leastPieces(benchmark::State& state)
{
    const Polygon star = starFor(state, 3);
    const auto corners = star.inSpace();
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(decomposeConvex(corners, star.contourSizes, ConvexMethod::leastPieces));
}
BENCHMARK(leastPieces)->Arg(8)->Arg(32)->Arg(128)->Unit(benchmark::kMicrosecond);

template<class Order>
void order(benchmark::State& state, Order make)
{
    Random random(4);
    IndexedMesh mesh = testsupport::sphereMesh(static_cast<std::uint32_t>(state.range(0)),
                                               2 * static_cast<std::uint32_t>(state.range(0)));
    testsupport::shuffle(mesh, random);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(make(mesh));
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK_CAPTURE(order, sgi, [](const IndexedMesh& m) { return sgiStrips(m.triangles).triangles; })
    ->Arg(130);
BENCHMARK_CAPTURE(order, dualGraph,
                  [](const IndexedMesh& m) { return dualGraphStrips(m.triangles).triangles; })
    ->Arg(130);
BENCHMARK_CAPTURE(order, hilbert, [](const IndexedMesh& m) { return hilbertOrder(m.triangles, m.positions); })
    ->Arg(130);
BENCHMARK_CAPTURE(order, universal, [](const IndexedMesh& m) { return universalOrder(m.triangles); })
    ->Arg(130);
BENCHMARK_CAPTURE(order, locality,
                  [](const IndexedMesh& m) { return localityOrder(m.triangles, m.vertexCount()); })
    ->Arg(130);
BENCHMARK_CAPTURE(order, library,
                  [](const IndexedMesh& m) { return libraryOrder(m.triangles, m.vertexCount()); })
    ->Arg(130);

} // namespace

BENCHMARK_MAIN();
