// SPDX-License-Identifier: Apache-2.0
// Any bytes may be given as a road network: they are read, or refused; a part of what is read is checked,
// asked for positions and meshed.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include <osgRoads/core/check/NetworkCheck.h>
#include <osgRoads/core/query/LaneRoute.h>
#include <osgRoads/core/query/MarkStrokes.h>
#include <osgRoads/core/query/ObjectInstances.h>
#include <osgRoads/core/query/RoadLocator.h>
#include <osgRoads/core/query/RoadSurface.h>
#include <osgRoads/core/read/ReadNetwork.h>
#include <osgRoads/core/surface/BuildRoadMesh.h>

#include "DearPart.h"

// NOLINTNEXTLINE(readability-identifier-naming): the name is libFuzzer's
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace
{

using namespace osgRoads::core;

constexpr std::size_t kMostRoads = 20, kMostMarks = 1000;
constexpr std::size_t kUsedOneOf = 16; // that takes far longer than reading
constexpr double kLongestM = 2e4; // the checks look at every 5 m: longer networks would take most of the time
constexpr double kLongestMeshM = 150.0; // a mesh has a cross-section each few decimetres

void require(bool condition)
{
    if (!condition) std::abort();
}

/// Positions on a road and back: no crash, and s stays on the road.
void askRoad(const RoadNetwork& network, const RoadLocator& locator, int index)
{
    const Road& road = network.roads[static_cast<std::size_t>(index)];
    for (const double share : {0.0, 0.37, 1.0})
    {
        const double s = share * road.length;
        const glm::dvec3 point = surfacePoint(road, s, -1.0);
        surfaceNormal(road, s, 1.0);
        const auto found = locator.nearest(point);
        if (!found) continue;
        const Road& on = network.roads[static_cast<std::size_t>(found->position.road)];
        require(on.isUsable);
        require(found->position.s >= -1e-6 && found->position.s <= on.length + 1e-6);
        locator.within(glm::dvec2(point), 5.0);
    }
    for (const LaneSection& section : road.sections)
        for (const auto* side : {&section.left, &section.right})
            for (const Lane& lane : *side)
                if (lane.marks.size() < kMostMarks) markStrokes(road, section, lane);
    for (const RoadObject& object : road.objects)
    {
        require(objectInstances(object).size() <= kMostInstances + object.repeats.size());
        for (const ObjectOutline& outline : object.outlines)
            outlineCorners(road, object, outline);
    }
}

/// The drawn surface: whole triangles of vertices that are there, and levels whose errors are numbers that do
/// not fall.
void checkMesh(RoadNetwork network)
{
    const PlacedNetwork placed(std::make_shared<const RoadNetwork>(std::move(network)));
    const RoadMesh mesh = buildRoadMesh(placed);
    require(mesh.indices.size() % 3 == 0);
    for (const std::uint32_t index : mesh.indices)
        require(index < mesh.vertices.size());
    for (const RoadChunk& chunk : mesh.chunks)
    {
        require(!chunk.levels.empty() && std::isfinite(chunk.radius));
        double errorM = 0.0;
        for (const ChunkLevel& level : chunk.levels)
        {
            require(level.firstIndex + level.indexCount <= mesh.indices.size());
            require(std::isfinite(level.errorM) && level.errorM >= errorM);
            errorM = level.errorM;
        }
    }
}

} // namespace

// NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    auto read = parseNetwork({reinterpret_cast<const char*>(data), size}, "fuzz");
    if (!read || !isDearPartDone(size, kUsedOneOf)) return 0;
    const RoadNetwork& network = read->network;
    double lengthM = 0.0;
    for (const Road& road : network.roads)
        lengthM += road.isUsable ? road.length : 0.0;
    if (lengthM > kLongestM) return 0;
    const RoadLocator locator(network);
    std::size_t asked = 0;
    int first = -1, last = -1;
    for (int i = 0; i < static_cast<int>(network.roads.size()) && asked < kMostRoads; ++i)
    {
        if (!network.roads[static_cast<std::size_t>(i)].isUsable) continue;
        ++asked;
        first = first < 0 ? i : first;
        last = i;
        askRoad(network, locator, i);
    }
    require(first >= 0); // else it would have been refused
    checkNetwork(network);
    const LaneGraph graph(network);
    const auto route = findRoute(network, graph, {first, 0.1, -1.0, 0.0}, {last, 0.2, -1.0, 0.0});
    if (route) route->at(network, 0.5 * route->lengthM);
    if (lengthM < kLongestMeshM) checkMesh(std::move(read->network));
    return 0;
}
