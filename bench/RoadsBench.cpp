// SPDX-License-Identifier: Apache-2.0
// Look-ups on a road network: road to world, and world to road without a hint; its drawn surface, and what a
// view of it costs. `roads_bench FILE.xodr`.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneSpan.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>
#include <osgRoads/core/surface/ChunkTree.h>

namespace
{

using namespace osgRoads::core;

constexpr std::size_t kPoints = 1 << 16;

/// Points on lanes, at random roads by their length.
struct Course
{
    std::vector<RoadPosition> positions;
    std::vector<glm::dvec3> points;
};

Course courseOf(const RoadNetwork& network)
{
    std::vector<double> lengths;
    for (const Road& road : network.roads)
        lengths.push_back(road.isUsable ? road.length : 0.0);
    std::discrete_distribution<int> roads(lengths.begin(), lengths.end());
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::mt19937 random(1);
    Course course;
    while (course.points.size() < kPoints)
    {
        const int index = roads(random);
        const Road& road = network.roads[static_cast<std::size_t>(index)];
        const double s = share(random) * road.length;
        const RoadExtent extent = extentAt(road, s);
        const double t = extent.rightT + share(random) * (extent.leftT - extent.rightT);
        course.positions.push_back({index, s, t, 0.0});
        course.points.push_back(surfacePoint(road, s, t));
    }
    return course;
}

void measure(const char* file, const RoadNetwork& network)
{
    static const Course course = courseOf(network);
    static const RoadLocator locator(network);
    benchmark::RegisterBenchmark("read",
                                 [file](benchmark::State& state)
                                 {
                                     for ([[maybe_unused]] auto _ : state)
                                         benchmark::DoNotOptimize(readNetwork(file));
                                 })
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("index",
                                 [&network](benchmark::State& state)
                                 {
                                     for ([[maybe_unused]] auto _ : state)
                                         benchmark::DoNotOptimize(RoadLocator(network));
                                 })
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark("check",
                                 [&network](benchmark::State& state)
                                 {
                                     for ([[maybe_unused]] auto _ : state)
                                         benchmark::DoNotOptimize(checkNetwork(network));
                                 })
        ->Unit(benchmark::kMillisecond);
    const auto each = [](const char* name, const auto& ask)
    {
        benchmark::RegisterBenchmark(name,
                                     [ask](benchmark::State& state)
                                     {
                                         std::size_t i = 0;
                                         for ([[maybe_unused]] auto _ : state)
                                             ask(i++ % kPoints);
                                         state.SetItemsProcessed(state.iterations());
                                     });
    };
    each("road_to_world", [&network](std::size_t i)
         { benchmark::DoNotOptimize(worldPosition(network, course.positions[i])); });
    each("surface_point",
         [&network](std::size_t i)
         {
             const RoadPosition& position = course.positions[i];
             benchmark::DoNotOptimize(surfacePoint(network.roads[static_cast<std::size_t>(position.road)],
                                                   position.s, position.t));
         });
    each("world_to_road",
         [](std::size_t i) { benchmark::DoNotOptimize(locator.nearest(glm::dvec2(course.points[i]))); });
    each("world_to_road_3d",
         [](std::size_t i) { benchmark::DoNotOptimize(locator.nearest(course.points[i])); });
}

/// The surface: how long it takes to make, how large it is, and the choice of levels for a driver on a random
/// road.
void measureSurface(const std::shared_ptr<const RoadNetwork>& network)
{
    static const PlacedNetwork placed(network);
    benchmark::RegisterBenchmark("mesh",
                                 [](benchmark::State& state)
                                 {
                                     for ([[maybe_unused]] auto _ : state)
                                     {
                                         const RoadMesh mesh =
                                             buildRoadMesh(placed, meshSettingsFor(placed.network()));
                                         state.counters["chunks"] = static_cast<double>(mesh.chunks.size());
                                         state.counters["vertices"] =
                                             static_cast<double>(mesh.vertices.size());
                                         state.counters["indices"] = static_cast<double>(mesh.indices.size());
                                     }
                                 })
        ->Unit(benchmark::kMillisecond);
    const auto choose = [network](bool byTree)
    {
        return [network, byTree](benchmark::State& state)
        {
            static const RoadMesh mesh = buildRoadMesh(placed);
            static const ChunkTree tree(mesh);
            const Course course = courseOf(*network);
            const glm::dmat4 projection = glm::perspective(0.7, 1.6, 0.5, 5000.0);
            std::size_t i = 0, chosen = 0;
            for ([[maybe_unused]] auto _ : state)
            {
                const glm::dvec3 eye = course.points[i++ % kPoints] + glm::dvec3(0.0, 0.0, 1.5);
                const glm::dmat4 look =
                    glm::lookAt(eye, eye + glm::dvec3(std::cos(i), std::sin(i), 0.0), {0.0, 0.0, 1.0});
                const auto view = viewlod::ViewState::fromMatrices(look, projection, 960, 600);
                chosen += (byTree ? chooseLevels(mesh, tree, view, {}) : chooseLevels(mesh, view, {})).size();
            }
            state.counters["chosen"] =
                benchmark::Counter(static_cast<double>(chosen), benchmark::Counter::kAvgIterations);
        };
    };
    benchmark::RegisterBenchmark("levels_of_every_chunk", choose(false))->Unit(benchmark::kMicrosecond);
    benchmark::RegisterBenchmark("levels_by_tree", choose(true))->Unit(benchmark::kMicrosecond);
}

} // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (argc != 2)
    {
        std::fprintf(stderr, "usage: roads_bench FILE.xodr\n");
        return 2;
    }
    static auto read = readNetwork(argv[1]);
    if (!read)
    {
        std::fprintf(stderr, "%s\n", read.error().message().c_str());
        return 1;
    }
    const auto network = std::make_shared<const RoadNetwork>(std::move(read->network));
    measure(argv[1], *network);
    measureSurface(network);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
