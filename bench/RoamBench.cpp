// SPDX-License-Identifier: Apache-2.0
// Measures how the ROAM mesh adapts along continuous flights, beside refinement from scratch in the same run;
// merges, ground queries, and building the error tree. The terrain is real if OSGTRAINER_REAL_DATA names it,
// else the tests' hills.
//   OSGTRAINER_REAL_DATA=… build/bin/roam_bench
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include <benchmark/benchmark.h>

#include <osgTerrainROAM/core/heightfield/DemImport.h>
#include <osgTerrainROAM/core/heightfield/GroundQuery.h>
#include <osgTerrainROAM/core/roam/DrawnGround.h>
#include <osgTerrainROAM/core/roam/GroundRay.h>
#include <osgTerrainROAM/core/roam/RoamMesh.h>
#include <osgTerrainROAM/core/roam/ScratchRefinement.h>

#include "SyntheticField.h"
#include "measurement/SplitFully.h"
#include "measurement/flights/BenchmarkFlight.h"
#include "measurement/flights/RasterCrop.h"

namespace
{

using namespace osgTerrainROAM::core;
using measurement::BenchmarkFlight;

std::optional<HeightField> realField()
{
    const char* folder = std::getenv("OSGTRAINER_REAL_DATA");
    if (!folder) return std::nullopt;
    auto imported = importDem(std::filesystem::path(folder) / measurement::kWhiteMountains.file);
    if (!imported) return std::nullopt;
    return std::move(*imported);
}

HeightField field1025()
{
    const auto real = realField();
    return real ? measurement::kWhiteMountains.of(*real) : testsupport::hills(1025, 1025, 90.0);
}

const std::shared_ptr<const RoamTile>& tile()
{
    static const auto placed = testsupport::planarTile(field1025());
    return placed;
}

/// Returns a tile on the curved Earth: the whole real raster, or hills.
const std::shared_ptr<const RoamTile>& curvedTile()
{
    static const auto placed = std::make_shared<const RoamTile>(
        PlacedTile(realField().value_or(testsupport::onTheEarth(testsupport::hills(1025, 1025, 90.0)))));
    return placed;
}

/// Reports the median, 99th percentile and largest of the frame times of a flight. Units: microseconds.
void report(benchmark::State& state, std::vector<double> frameUs, double triangles)
{
    std::sort(frameUs.begin(), frameUs.end());
    const auto at = [&](double share)
    { return frameUs[static_cast<std::size_t>(share * (frameUs.size() - 1))]; };
    state.counters["p50_us"] = at(0.5);
    state.counters["p99_us"] = at(0.99);
    state.counters["max_us"] = frameUs.back();
    state.counters["triangles"] = triangles;
}

template<class Frame>
void fly(benchmark::State& state, const Frame& adapt)
{
    std::vector<double> frameUs;
    double triangles = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        for (int frame = 0; frame < BenchmarkFlight::kFrames; ++frame)
        {
            const auto view = BenchmarkFlight{}.view(tile()->tile, frame);
            const auto begin = std::chrono::steady_clock::now();
            triangles = adapt(view);
            const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - begin;
            if (frame > 0) frameUs.push_back(spent.count()); // the first frame builds the mesh
        }
    }
    report(state, std::move(frameUs), triangles);
}

template<Driver driver>
void flight(benchmark::State& state)
{
    RoamMesh mesh(tile(), driver);
    double changes = 0, checks = 0, frames = 0;
    fly(state,
        [&](const viewlod::ViewState& view)
        {
            const auto result =
                mesh.refine(view, {.errorTolerancePx = static_cast<double>(state.range(0)) / 10.0});
            changes += result.splits + result.merges;
            checks += result.checks;
            ++frames;
            return result.leaves;
        });
    state.counters["changes_per_frame"] = changes / frames;
    state.counters["checks_per_frame"] = checks / frames;
    state.counters["bytes_per_triangle"] = static_cast<double>(mesh.memoryBytes()) / mesh.tree().leafCount();
}

/// Measures a flight with morphing. The tolerance holds for the morphed surface, so the mesh is finer.
void flightMorphing(benchmark::State& state)
{
    RoamMesh mesh(tile());
    mesh.setMorphing(true);
    double moved = 0, frames = 0;
    fly(state,
        [&](const viewlod::ViewState& view)
        {
            const auto result =
                mesh.refine(view, {.errorTolerancePx = static_cast<double>(state.range(0)) / 10.0});
            moved += static_cast<double>(mesh.changes().vertices.size());
            ++frames;
            return result.leaves;
        });
    state.counters["vertices_uploaded"] = moved / frames;
}

void flightFromScratch(benchmark::State& state)
{
    std::vector<GridTriangle> leaves;
    fly(state,
        [&](const viewlod::ViewState& view)
        {
            refineFromScratch(tile(), view, static_cast<double>(state.range(0)) / 10.0, leaves);
            return leaves.size();
        });
}

std::vector<glm::dvec2> randomPlaces(const PlacedTile& placed)
{
    std::vector<glm::dvec2> places;
    testsupport::Random random(9);
    for (int i = 0; i < 4096; ++i)
        places.emplace_back(placed.frame().positionAt(random.unit() * (placed.grid().dataColumns() - 2),
                                                      random.unit() * (placed.grid().dataRows() - 2), 0.0));
    return places;
}

template<class Query>
void queries(benchmark::State& state, const PlacedTile& placed, const Query& query)
{
    const auto places = randomPlaces(placed);
    std::size_t next = 0;
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(query(places[next++ % places.size()]));
    state.SetItemsProcessed(state.iterations());
}

const std::shared_ptr<const RoamTile>& tileOf(Placement placement)
{
    return placement == Placement::curved ? curvedTile() : tile();
}

template<Placement placement>
void trueGround(benchmark::State& state)
{
    const PlacedTile& placed = tileOf(placement)->tile;
    queries(state, placed, [&](const glm::dvec2& p) { return groundAt(placed, p.x, p.y); });
}

/// Measures single queries of the drawn ground, on the mesh of the benchmark flight, 30 000 triangles.
template<Placement placement>
void drawnGround(benchmark::State& state)
{
    RoamMesh mesh(tileOf(placement));
    mesh.refine(BenchmarkFlight{}.view(mesh.tile().tile, 0), {.errorTolerancePx = 3.6});
    queries(state, mesh.tile().tile,
            [&](const glm::dvec2& p) { return drawnGroundAt(mesh.tree(), p.x, p.y); });
}

/// Measures the same queries, all in one call.
template<Placement placement>
void drawnGroundBatch(benchmark::State& state)
{
    RoamMesh mesh(tileOf(placement));
    mesh.refine(BenchmarkFlight{}.view(mesh.tile().tile, 0), {.errorTolerancePx = 3.6});
    const auto places = randomPlaces(mesh.tile().tile);
    std::vector<std::optional<DrawnGround>> grounds(places.size());
    for ([[maybe_unused]] auto _ : state)
        drawnGroundAt(mesh.tree(), places, grounds);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(places.size()));
    state.counters["triangles"] = mesh.tree().leafCount();
}

/// Measures rays 5 km long from 300 m above the ground.
void groundRay(benchmark::State& state)
{
    testsupport::Random random(10);
    queries(state, tile()->tile,
            [&](const glm::dvec2& p)
            {
                const double heading = 6.283 * random.unit();
                const glm::dvec3 direction =
                    glm::normalize(glm::dvec3(std::cos(heading), std::sin(heading), -0.05));
                const auto ground = groundAt(tile()->tile, p.x, p.y);
                return hitGround(*tile(), {p.x, p.y, ground ? ground->position.z + 300.0 : 0.0}, direction,
                                 5000.0);
            });
}

void errorTree(benchmark::State& state)
{
    const auto side = static_cast<int>(state.range(0));
    const PlacedTile placed(testsupport::hills(side, side), Placement::planar);
    for ([[maybe_unused]] auto _ : state)
        benchmark::DoNotOptimize(ErrorTree(placed));
    state.SetItemsProcessed(state.iterations() * side * side);
}

/// Measures removing the subtree below a triangle. Argument: the level of the triangle. Before each round the
/// subtree is split down to the samples; that is not timed.
template<class Merge>
void mergeSubtree(benchmark::State& state, const Merge& merge)
{
    DiamondTree tree(tile());
    TriangleId top = DiamondTree::kRoots[0];
    for (int level = 0; level < state.range(0); ++level)
    {
        if (tree.isLeaf(top)) tree.forceSplit(top);
        top = tree.children(top)[static_cast<std::size_t>(level % 2)];
    }
    double removed = 0;
    for ([[maybe_unused]] auto _ : state)
    {
        state.PauseTiming();
        measurement::splitFully(tree, {top});
        tree.clearChanges();
        state.ResumeTiming();
        removed += merge(tree, tree.splitVertex(top));
    }
    state.counters["removed"] = removed / static_cast<double>(state.iterations());
    state.counters["ns_per_removed"] =
        benchmark::Counter(removed * 1e-9, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void enhMerge(benchmark::State& state)
{
    mergeSubtree(state, [](DiamondTree& tree, VertexSlot v) { return tree.enhMerge(v); });
}

void singleMerges(benchmark::State& state)
{
    mergeSubtree(state, [](DiamondTree& tree, VertexSlot v) { return tree.forceMerge(v); });
}

// Arguments of flights: tolerance in tenths of a pixel; 36 gives about 30 000 triangles on the real crop.
BENCHMARK(flight<Driver::wheel>)->Arg(36)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(flight<Driver::walk>)->Arg(36)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(flight<Driver::queue>)->Arg(36)->Unit(benchmark::kMillisecond);
BENCHMARK(flightMorphing)->Arg(36)->Unit(benchmark::kMillisecond);
BENCHMARK(flightFromScratch)->Arg(36)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(enhMerge)->DenseRange(2, 12, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(singleMerges)->DenseRange(2, 12, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(trueGround<Placement::planar>);
BENCHMARK(trueGround<Placement::curved>);
BENCHMARK(drawnGround<Placement::planar>);
BENCHMARK(drawnGround<Placement::curved>);
BENCHMARK(drawnGroundBatch<Placement::planar>);
BENCHMARK(drawnGroundBatch<Placement::curved>);
BENCHMARK(groundRay);
BENCHMARK(errorTree)->Arg(257)->Arg(1025)->Unit(benchmark::kMillisecond)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
